// Evaluation: call by value, normal forms as values. Names with a rule compute, names without a rule stay
// (`put(block4, on(block1))` is its own value). So a content such as `\x. put(x, center(region))` evaluates to a
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
#include <utility>
#include <vector>

#include "continua/term/derivation.h"
#include "continua/term/facts.h"
#include "continua/term/term.h"
#include "continua/term/term_text.h"

namespace continua {

/// An application of a continuation, for the log (SEMANTICS.md §2: every application is a record). The terms carry
/// their types.
struct Application {
  Term function;
  Term argument;  ///< before raising
  Term result;
  std::string rule;  ///< name of the raising rule that lifted the argument, or empty
};

class Evaluation;

/// The rule of a name that computes, with `arity` arguments, all values. It is not called while an argument contains
/// bound variables. A null argument gives null, unless `takes_null`. `compute` must return a value. Since `term` is
/// consistent with every type, arguments may be of another kind than the name's type says; see rules.h.
struct Rule {
  std::size_t arity = 0;
  std::function<Term(std::span<const Term> arguments, Evaluation& evaluation)> compute;
  bool takes_null = false;
};

using Rules = std::map<std::string, Rule, std::less<>>;

struct RaisingRule;  // term/raising.h
using RaisingRules = std::vector<RaisingRule>;

/// Rules of several sources by name: a value. The first of two rules with the same name counts. `raising`: the rules by
/// which `fill` raises an argument of the wrong type, or nullptr; they must outlive the table.
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
/// The types of these names, with core_signature().
const Signature& term_signature();

/// One evaluation: the sources of its values, and a record of its applications, margin and exhaustion.
class Evaluation {
 public:
  /// The value of a name without a rule: a slot, a register, a definition; nullptr if it has none. `kept`: it is taken
  /// as it stands, and evaluated only if it is applied.
  struct Held {
    const Term* value = nullptr;
    bool kept = false;
    Held(const Term* its_value, bool is_kept = false) : value(its_value), kept(is_kept) {}
  };
  /// A function is never the value of a name of type e, because an object may have the same name as a word.
  using Lookup = std::function<Held(Name name)>;
  /// `rules` must outlive the evaluation.
  Evaluation(const RuleTable& rules, Lookup lookup, Facts known = {})
      : rules_(rules), lookup_(std::move(lookup)), facts_(known) {}

  /// The value of a closed term. Results of lookup are evaluated too, unless they are kept. The number of steps is
  /// bounded: past the bound the value is null and `exhausted` is set.
  Term value(const Term& term);
  /// Applies a function value to a value.
  Term apply(const Term& function, const Term& argument);

  /// For rules: the facts that they read besides their arguments.
  const Facts& facts() const { return facts_; }
  /// For rules: how arguments are raised; nullptr if they are not.
  const RaisingRules* raising() const { return rules_.raising(); }
  /// For rules: accounts for `steps` of work. False, with `exhausted` set, past the bound; the rule then gives null.
  bool spend(std::size_t steps);
  /// For rules: notes that a change of a length or number by `distance` would have changed a decision.
  void note_margin(double distance) { margin = std::min(margin, distance); }
  /// For rules: notes that two numbers were compared. Two whole numbers (counts) have no margin.
  void note_compared(double a, double b);

  /// Applications made by `fill`, in order.
  std::vector<Application> applications;
  /// The smallest distance that was noted: how near a decision was to going otherwise.
  double margin = std::numeric_limits<double>::infinity();
  /// A value was given up: it took too many steps, went too deep or grew too large.
  bool exhausted = false;
  /// Told of every application, if there is one; it must outlive the evaluation.
  Derivation* derivation = nullptr;
  /// A defined name that is applied to a bound variable waits for the variable's value. Without this, its definition is
  /// worked out in all its branches first, so that a value that is a function shows what it does. Where the value is
  /// a truth value or a text, nobody sees that.
  bool definitions_wait = false;

 private:
  enum class Step { done, again };
  // A head with its arguments, under evaluation. The first `ready` arguments are values already.
  struct Redex {
    Term head;
    std::vector<Term> arguments;
    std::size_t ready = 0;
  };

  Term evaluated(const Term& term);
  Term evaluated_list(const Term& term);
  Term reduced(Redex redex);
  Step reduce_constant(Redex& redex);
  Term value_of(Name name, Term held);
  Step reduce_choice(Redex& redex);
  Step reduce_rule(Redex& redex, const Rule& rule);
  void reduce_lambda(Redex& redex);
  Step keep(Redex& redex, bool told = false);
  void make_ready(Redex& redex, std::size_t count);
  Term bounded(Term term);
  void give_up();

  const RuleTable& rules_;
  Lookup lookup_;
  Facts facts_;
  std::vector<std::pair<Name, Term>> values_;  ///< of names that were evaluated, few
  std::size_t steps_ = 0;
  int depth_ = 0;
};

}  // namespace continua
