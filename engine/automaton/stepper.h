// One step of the automaton: an input is offered, the applicable transitions are found, one is chosen and fired, then
// ε-transitions until none applies (SEMANTICS.md §1). A step gives its events back as a list; it writes or draws
// nothing anywhere else.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "continua/automaton/firing.h"

namespace continua {

/// So many ε-transitions may follow one another; then the step ends with trouble.
inline constexpr int most_epsilon_steps = 1000;

struct Step {
  Configuration after;
  std::vector<StepEvent>
      events;  ///< in the order in which they happened; a symbol comes before the operation that puts it on the stack
};

/// A value: every copy does the same.
class Stepper {
 public:
  /// `facts` are rules besides those of the language and the machine; `raising` is how `fill` lifts arguments, and must
  /// outlive the stepper and its copies.
  Stepper(std::shared_ptr<const Machine> machine, const Rules& facts, const RaisingRules* raising = nullptr);

  const Machine& machine() const { return *machine_; }

  /// The configuration in which a run begins: start state, the bottom symbol, registers as declared; no ε-transition
  /// has been tried.
  Configuration initial() const;

  /// `initial()`; then ε-transitions, where the machine always tries them.
  Step begin(const Facts& facts, Chooser& chooser) const;

  /// Offers inputs of which one is to be taken: alternatives, such as the n best guesses of a recogniser; REQUIRES one
  /// at least. A transition that takes any of them is a candidate, with the weight that the confidence of its input
  /// gives it. Without a candidate the configuration stays and the events end with RefusedInput.
  Step step(const Configuration& before, std::span<const Input> inputs, const Facts& facts, Chooser& chooser) const;
  Step step(const Configuration& before, const Input& input, const Facts& facts, Chooser& chooser) const {
    return step(before, std::span(&input, 1), facts, chooser);
  }

  /// The same without an account, which takes a fraction of the time: nothing is said or done, only the configuration
  /// changes. Nothing if all inputs are refused.
  std::optional<Configuration> advance(const Configuration& before, std::span<const Input> inputs, const Facts& facts,
                                       Chooser& chooser) const;
  std::optional<Configuration> advance(const Configuration& before, const Input& input, const Facts& facts,
                                       Chooser& chooser) const {
    return advance(before, std::span(&input, 1), facts, chooser);
  }

  /// The configuration that a row of the machine implies, from one in which its terms are read. No gate is asked and no
  /// effect performed.
  Configuration implied(const Implied& row, const Configuration& before, const Input& input, const Facts& facts,
                        std::vector<StepEvent>* account) const;

  /// The value of a term of the machine in a configuration, and the inputs it came from.
  Cell value(const Term& term, const Configuration& configuration, const Input& input, const Facts& facts) const;

  /// For those who choose and keep configurations themselves. `inputs`: none for ε. The stepper, the inputs, all facts
  /// and `account` must outlive the firing.
  Firing firing(Configuration configuration, std::span<const Input> inputs, const Facts& facts,
                std::vector<StepEvent>* account) const;
  /// `input`: nullptr for ε.
  Firing firing(Configuration configuration, const Input* input, const Facts& facts,
                std::vector<StepEvent>* account) const {
    return firing(std::move(configuration), std::span(input, input ? 1 : 0), facts, account);
  }

 private:
  bool offer(Firing& firing, std::span<const Input> inputs, Chooser& chooser, std::vector<StepEvent>* account) const;
  void settle(Firing& firing, Chooser& chooser, std::vector<StepEvent>* account) const;

  std::shared_ptr<const Machine> machine_;
  RuleTable rules_;  ///< of the language, of facts, and the machine's own: is_input, certainty, wording, tables
};

/// Refused inputs, and the reasons: no transition takes them, conditions do not hold, or too many apply.
RefusedInput refusal(const Machine& machine, StateIndex state, Applicable found, std::span<const Input> inputs);

}  // namespace continua
