// One step of the automaton: finds the transitions that apply to an input, chooses and fires one, then ε-transitions
// until none applies (SEMANTICS.md §1). All that happened is returned as a list of events; there are no side effects.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "continua/automaton/firing.h"

namespace continua {

/// The most ε-transitions in a row; after these the step ends with Trouble.
inline constexpr int most_epsilon_steps = 1000;

struct Step {
  Configuration after;
  std::vector<StepEvent> events;  ///< in order; a new symbol comes before the transition that pushes it
};

/// A value: every copy does the same.
class Stepper {
 public:
  /// `facts`: rules besides those of the language and the machine. `raising`: the rules by which `fill` lifts
  /// arguments; they must outlive the stepper and its copies.
  Stepper(std::shared_ptr<const Machine> machine, const Rules& facts, const RaisingRules* raising = nullptr);

  const Machine& machine() const { return *machine_; }

  /// The configuration in which a run begins: start state, bottom symbol, registers as declared. No ε-transition has
  /// been tried.
  Configuration initial() const;

  /// `initial()`, then ε-transitions if the machine always tries them.
  Step begin(const Facts& facts, Chooser& chooser) const;

  /// Offers alternative inputs of which one is taken, such as the n best guesses of a recogniser. REQUIRES at least
  /// one. Each transition that takes one of them is a candidate, weighted with the confidence of its input. Without
  /// candidates the configuration stays and the events end with RefusedInput.
  Step step(const Configuration& before, std::span<const Input> inputs, const Facts& facts, Chooser& chooser) const;
  Step step(const Configuration& before, const Input& input, const Facts& facts, Chooser& chooser) const {
    return step(before, std::span(&input, 1), facts, chooser);
  }

  /// A step without events, which takes a fraction of the time: nothing is said or done, only the configuration
  /// changes. Returns nothing if all inputs are refused.
  std::optional<Configuration> advance(const Configuration& before, std::span<const Input> inputs, const Facts& facts,
                                       Chooser& chooser) const;
  std::optional<Configuration> advance(const Configuration& before, const Input& input, const Facts& facts,
                                       Chooser& chooser) const {
    return advance(before, std::span(&input, 1), facts, chooser);
  }

  /// The configuration that a row of the machine implies. Its terms are evaluated in `before`. No gate is tested and no
  /// effect performed.
  Configuration implied(const Implied& row, const Configuration& before, const Input& input, const Facts& facts,
                        std::vector<StepEvent>* account) const;

  /// The value of a term of the machine in a configuration, with its sources.
  Cell value(const Term& term, const Configuration& configuration, const Input& input, const Facts& facts) const;

  /// For callers that choose and keep configurations themselves. `inputs`: none for ε. The stepper, the inputs, all
  /// facts and `account` must outlive the firing.
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
  RuleTable rules_;  ///< of the language, of the facts, and of the machine: is_input, certainty, wording, tables
};

/// The event for refused inputs, with the reasons: no transition takes the input, no condition holds, or too many
/// apply.
RefusedInput refusal(const Machine& machine, StateIndex state, Applicable found, std::span<const Input> inputs);

}  // namespace continua
