// One step of the automaton: an input is offered, the applicable transitions are found, one is chosen and fired, then
// ε-transitions until none applies (semantics §1). Everything that happened comes back as a list of events; nothing is
// written or drawn anywhere else.
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
  std::vector<StepEvent> events;  ///< in the order in which they happened; a symbol before what puts it on the stack
};

class Stepper {
 public:
  /// `methods` are facts of the world, read anew at every step; `raising` is how `fill` lifts arguments. Both must
  /// outlive the stepper.
  Stepper(std::shared_ptr<const Machine> machine, const Rules& methods, const RaisingRules* raising = nullptr);

  const Machine& machine() const { return *machine_; }

  /// The configuration in which a run begins: start state, the bottom symbol, registers as declared; no ε-transition
  /// has been tried.
  Configuration initial() const;

  /// `initial()`; then ε-transitions, where the machine always tries them.
  Step begin(const Beliefs& beliefs, Chooser& chooser);

  /// Offers inputs of which one is to be taken: alternatives, such as the n best guesses of a recogniser; REQUIRES one
  /// at least. What takes any of them is a candidate, with the weight that the confidence of its input gives it. If
  /// nothing does, the configuration stays and the events end with RefusedInput.
  Step step(const Configuration& before, std::span<const Input> inputs, const Beliefs& beliefs, Chooser& chooser);
  Step step(const Configuration& before, const Input& input, const Beliefs& beliefs, Chooser& chooser) {
    return step(before, std::span(&input, 1), beliefs, chooser);
  }

  /// The same without an account of what happened, which takes a fraction of the time: nothing is said or done, only
  /// the configuration changes. Nothing if all inputs are refused.
  std::optional<Configuration> advance(const Configuration& before, std::span<const Input> inputs,
                                       const Beliefs& beliefs, Chooser& chooser);
  std::optional<Configuration> advance(const Configuration& before, const Input& input, const Beliefs& beliefs,
                                       Chooser& chooser) {
    return advance(before, std::span(&input, 1), beliefs, chooser);
  }

  /// The configuration that a row of the machine implies, from one in which its terms are read. No gate is asked and no
  /// effect performed.
  Configuration implied(const Implied& row, const Configuration& before, const Input& input, const Beliefs& beliefs,
                        std::vector<StepEvent>* account);

  /// The value of a term of the machine in a configuration, and the inputs it came from.
  Cell value(const Term& term, const Configuration& configuration, const Input& input, const Beliefs& beliefs);

  /// For those who choose and keep configurations themselves. `inputs`: none for ε. They, `beliefs` and `account` must
  /// outlive it, and firings of one stepper must not overlap under different beliefs.
  Firing firing(Configuration configuration, std::span<const Input> inputs, const Beliefs& beliefs,
                std::vector<StepEvent>* account);
  /// `input`: nullptr for ε.
  Firing firing(Configuration configuration, const Input* input, const Beliefs& beliefs,
                std::vector<StepEvent>* account) {
    return firing(std::move(configuration), std::span(input, input ? 1 : 0), beliefs, account);
  }

 private:
  bool offer(Firing& firing, std::span<const Input> inputs, Chooser& chooser, std::vector<StepEvent>* account);
  void settle(Firing& firing, Chooser& chooser, std::vector<StepEvent>* account);

  std::shared_ptr<const Machine> machine_;
  Rules own_rules_;                   ///< is_input, certainty, wording, tables: read `beliefs_`
  std::optional<RuleTable> rules_;    ///< once own_rules_ are complete
  const Beliefs* beliefs_ = nullptr;  ///< those of the step under way
};

/// Inputs that were refused, and why: what no transition takes, what their conditions say, or too many that apply.
RefusedInput refusal(const Machine& machine, StateIndex state, Applicable found, std::span<const Input> inputs);

}  // namespace continua
