// One step of the automaton: an input is offered, the applicable transitions are found, one is chosen and fired, then
// ε-transitions until none applies (semantics §1). Everything that happened comes back as a list of events; nothing is
// written or drawn anywhere else.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "automaton/firing.h"

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

  /// Offers an input. If no transition takes it the configuration stays and the events end with RefusedInput.
  Step step(const Configuration& before, const Input& input, const Beliefs& beliefs, Chooser& chooser);

  /// The same without an account of what happened, which takes a fraction of the time: nothing is said or done, only
  /// the configuration changes. Nothing if the input is refused.
  std::optional<Configuration> advance(const Configuration& before, const Input& input, const Beliefs& beliefs,
                                       Chooser& chooser);

  /// The value of a term of the machine in a configuration, and the inputs it came from.
  Cell value(const Term& term, const Configuration& configuration, const Input& input, const Beliefs& beliefs);

  /// For those who choose and keep configurations themselves. `input`, `beliefs` and `account` must outlive it, and
  /// firings of one stepper must not overlap under different beliefs.
  Firing firing(Configuration configuration, const Input* input, const Beliefs& beliefs,
                std::vector<StepEvent>* account);

 private:
  bool offer(Firing& firing, const Input& input, Chooser& chooser, std::vector<StepEvent>* account);
  void settle(Firing& firing, Chooser& chooser, std::vector<StepEvent>* account);

  std::shared_ptr<const Machine> machine_;
  Rules own_rules_;                   ///< is_input, certainty, wording, tables: read `beliefs_`
  std::optional<RuleTable> rules_;    ///< once own_rules_ are complete
  const Beliefs* beliefs_ = nullptr;  ///< those of the step under way
};

/// Why an input was refused: what no transition takes, or what their conditions say.
std::string refusal_reason(const Machine& machine, StateIndex state, const Applicable& found, const Input& input);

}  // namespace continua
