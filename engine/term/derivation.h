// The derivation of a value: the applications that it is made of (SEMANTICS.md §2: every application is a record). An
// evaluation applies much on its way, in conditions and searches; those count here whose results are parts of its
// value, and of no value that it read. So put(cup, was(cup)) has three applications where the cup alone was read, and
// none where it was read as a whole.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "continua/term/term.h"

namespace continua {

struct Application;

class Derivation {
 public:
  /// A value was read: its parts came about before.
  void read(const Term& value) { read_.push_back(value); }
  /// Evaluation goes below the lambda, until leave(). Its variable is told as a constant of the same name.
  void enter(const Term& lambda);
  void leave() { binders_.pop_back(); }
  /// A function was applied. `reduced`: it is a lambda; otherwise it is a name that nothing computes.
  void applied(const Term& function, const Term& argument, const Term& result, bool reduced);

  /// The applications of which `value` is made, inner ones first, besides those in `filled`. A reduction covers all
  /// that its result has from its function.
  std::vector<Application> of(const Term& value, std::span<const Application> filled) const;

 private:
  struct Step {
    Term function, argument, result;  // may have variables of lambdas around
    bool reduced = false;
    std::vector<std::pair<std::string, Type>> binders;  // the outermost first
  };
  std::vector<Term> read_;
  std::vector<std::pair<std::string, Type>> binders_;
  std::vector<Step> steps_;
};

}  // namespace continua
