// Evaluation: call by value, normal forms as values. Names that have a rule compute, names that have none stay
// (`put(block4, on(block1))` is its own value), so a content such as `\x. put(x, center(region))` evaluates to a
// command with its place filled in and its theme still open.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "term/term.h"

namespace continua {

/// One application of a continuation, as the log keeps it (semantics §2: every application is a record).
struct Application {
  Term function, argument, result;
  std::string rule;  ///< name of the raising rule that lifted the argument, or empty
};

class Evaluation;

/// What a name computes. Arguments are values, `arity` many. A rule that cannot say (an argument still contains
/// bound variables, see Evaluation) is not called. Null in gives null out unless `takes_null`.
struct Rule {
  std::size_t arity = 0;
  std::function<Term(std::span<const Term> arguments, Evaluation& evaluation)> compute;
  bool takes_null = false;
};

using Rules = std::map<std::string, Rule, std::less<>>;

/// The rules of the language's own names: and, or, not, comparisons, arithmetic, if; and of lists and terms:
/// size head last nth tail append reverse prefixes suffixes map filter some every sort_by contains zip …,
/// open fill program argument mentions text place (documented in term/FUNCTIONS.md).
const Rules& term_rules();
/// Their types, core_signature() included.
const Signature& term_signature();

/// One evaluation: where names get their values from, and what it did.
class Evaluation {
 public:
  /// Value of a name that is no function of ours: a slot, a register, a definition. nullptr: it has none.
  /// Every set of rules is asked in turn; `rules` must outlive the evaluation.
  using Lookup = std::function<const Term*(const std::string& name)>;
  Evaluation(std::vector<const Rules*> rules, Lookup lookup) : rules_(std::move(rules)), lookup_(std::move(lookup)) {}

  /// The value of a closed term. Values found by lookup are evaluated where they are not values yet.
  /// Ends after a bounded number of steps (then null), whatever the term.
  Term value(const Term& term);
  /// Applies a function value to a value.
  Term apply(const Term& function, const Term& argument);

  /// Applications made by `fill`, in order.
  std::vector<Application> applications;
  /// The smallest distance of two numbers that were compared and are no whole numbers: how near a decision was.
  double margin = std::numeric_limits<double>::infinity();

 private:
  std::vector<const Rules*> rules_;
  Lookup lookup_;
  std::size_t steps_ = 0;
};

}  // namespace continua
