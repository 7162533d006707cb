// Evaluation: call by value, normal forms as values. Names that have a rule compute, names that have none stay
// (`put(block4, on(block1))` is its own value), so a content such as `\x. put(x, center(region))` evaluates to a
// command with its place filled in and its theme still open.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "continua/term/facts.h"
#include "continua/term/term.h"
#include "continua/term/term_text.h"

namespace continua {

/// One application of a continuation, as the log keeps it (SEMANTICS.md §2: every application is a record). The types
/// follow from the terms.
struct Application {
  Term function;
  Term argument;  ///< as it was given, not raised
  Term result;
  std::string rule;  ///< name of the raising rule that lifted the argument, or empty
};

class Evaluation;

/// The function behind a name. Arguments are values, `arity` many. A rule is not called while an argument still
/// contains bound variables. Null in gives null out unless `takes_null`. The result must be a value. Since `term` goes
/// with every type, arguments may be of another kind than the name's type says; see rules.h.
struct Rule {
  std::size_t arity = 0;
  std::function<Term(std::span<const Term> arguments, Evaluation& evaluation)> compute;
  bool takes_null = false;
};

using Rules = std::map<std::string, Rule, std::less<>>;

struct RaisingRule;  // term/raising.h
using RaisingRules = std::vector<RaisingRule>;

/// Rules of several sources by name: a value. The first of two rules with one name counts. `raising` are the rules by
/// which `fill` raises an argument of the wrong type; nullptr: it raises none. They must outlive the table.
class RuleTable {
 public:
  explicit RuleTable(std::initializer_list<const Rules*> sources, const RaisingRules* raising = nullptr);
  const Rule* find(Name name) const {
    const auto found = rules_.find(name);
    return found == rules_.end() ? nullptr : &found->second;
  }
  const RaisingRules* raising() const { return raising_; }

 private:
  std::unordered_map<Name, Rule, Name::Hash> rules_;
  const RaisingRules* raising_;
};

/// The rules of the language's own names: operators, `if`, and functions of lists, terms, texts, places and numbers,
/// documented in term/FUNCTIONS.md.
const Rules& term_rules();
/// Their types, core_signature() included.
const Signature& term_signature();

/// One evaluation: the source of its names' values, and a record of its work.
class Evaluation {
 public:
  /// Value of a name that is no function of ours: a slot, a register, a definition. nullptr: it has none. A function is
  /// not the value of a name of type e: an object may be called like the word for it.
  /// `rules` must outlive the evaluation.
  using Lookup = std::function<const Term*(Name name)>;
  Evaluation(const RuleTable& rules, Lookup lookup, Facts known = {})
      : rules_(rules), lookup_(std::move(lookup)), facts_(known) {}

  /// The value of a closed term. A value found by lookup is evaluated further if it is none yet. Ends after a bounded
  /// number of steps, whatever the term; then the value is null and `exhausted` is set.
  Term value(const Term& term);
  /// Applies a function value to a value.
  Term apply(const Term& function, const Term& argument);

  /// The facts that rules read besides their arguments.
  const Facts& facts() const { return facts_; }
  /// For rules: how arguments are raised; nullptr: they are not.
  const RaisingRules* raising() const { return rules_.raising(); }
  /// For rules: allows `steps` more of work, or sets `exhausted`; the rule then gives null.
  bool spend(std::size_t steps);
  /// For rules: a decision would have been another one had a length or number been different by `distance`.
  void note_margin(double distance) { margin = std::min(margin, distance); }
  /// For rules: two numbers were compared. Between whole numbers (counts) nothing is near.
  void note_compared(double a, double b);

  /// Applications made by `fill`, in order.
  std::vector<Application> applications;
  /// The smallest distance of two numbers that were compared and are no whole numbers: how near a decision was.
  double margin = std::numeric_limits<double>::infinity();
  /// A value was given up, because it took too many steps, went too deep or grew too large.
  bool exhausted = false;

 private:
  enum class Step { done, again };
  // A head applied to arguments, on the way to its value. The first `ready` arguments are values already.
  struct Redex {
    Term head;
    std::vector<Term> arguments;
    std::size_t ready = 0;
  };

  Term evaluated(const Term& term);
  Term evaluated_list(const Term& term);
  Term reduced(Redex redex);
  Step reduce_constant(Redex& redex);
  Step reduce_choice(Redex& redex);
  Step reduce_rule(Redex& redex, const Rule& rule);
  Step keep(Redex& redex);
  void make_ready(Redex& redex, std::size_t count);
  Term bounded(Term term);
  void give_up();

  const RuleTable& rules_;
  Lookup lookup_;
  Facts facts_;
  std::size_t steps_ = 0;
  int depth_ = 0;
};

}  // namespace continua
