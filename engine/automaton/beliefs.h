// The avatar's certainty about its perceptions: a table of concepts, raised by evidence, answers and its own words.
// Gates read it as `certainty(symbol)`. The machine declares the table (FORMAT.md, Beliefs).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/automaton/symbol_set.h"
#include "continua/term/term.h"

namespace continua {

struct Concept {
  std::string name;
  std::vector<std::size_t> related;
  std::string word;  ///< lower case; empty: cannot be overheard
  std::optional<double> fixed;
};

struct Evidence {
  SymbolSet inputs;
  std::vector<std::size_t> concepts;
  std::vector<double> levels;  ///< ascending, not empty
};

struct Answer {
  std::optional<Term> when;
  SymbolSet inputs;
  Term about;                 ///< of type text: the symbol that the question was about
  std::optional<double> set;  ///< nullopt: raise
};

struct BeliefTable {
  std::vector<Concept> concepts;
  std::vector<Evidence> evidence;
  std::vector<Answer> answers;
  double overheard = 0;
};

/// A concept's certainty before and after a change.
struct BeliefChange {
  std::string name;
  double was = 0, value = 0;
};

/// The certainties of all concepts, as a value. The table must outlive it.
class Beliefs {
 public:
  explicit Beliefs(const BeliefTable& table);

  /// The product over the symbol's concepts, where each counts with the largest of its own and its related certainties;
  /// 1 if the symbol has no concepts.
  double certainty(std::string_view symbol) const;

  /// Each returns its changes, in the table's order.
  std::vector<BeliefChange> raise(std::string_view symbol);
  std::vector<BeliefChange> set(std::string_view symbol, double value);
  std::vector<BeliefChange> overhear(std::string_view utterance);

  /// The certainties that differ from `before`, beliefs of the same table, in the table's order.
  std::vector<BeliefChange> changes_since(const Beliefs& before) const;

  /// Beliefs of another table with these certainties, by the names of concepts. A concept that is fixed there, or new,
  /// has its initial certainty.
  Beliefs carried_over(const BeliefTable& table) const;

 private:
  void change(std::size_t concept_index, double value, std::vector<BeliefChange>& changes);

  const BeliefTable* table_;
  std::vector<double> certainty_;
};

}  // namespace continua
