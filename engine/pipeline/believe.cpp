#include "continua/pipeline/believe.h"

#include <utility>

namespace continua {

Tick believe(const Engine& engine, EngineState state, const Input& input, const WorldSnapshot& world) {
  Tick tick{std::move(state), {}};
  EngineState& after = tick.after;
  const auto note = [&](const std::vector<BeliefChange>& changes) {
    tick.events.insert(tick.events.end(), changes.begin(), changes.end());
  };
  const auto value = [&](const Term& term) {
    return engine.stepper.value(term, after.configuration, input, facts_of(after, world)).value;
  };
  for (const auto& answer : engine.machine->beliefs.answers) {
    if (!answer.inputs.contains(input.symbol)) continue;
    if (answer.when && !value(*answer.when).is_true()) continue;
    const Term about = value(answer.about);
    if (about.kind() != Term::Kind::text) continue;
    note(answer.set ? after.beliefs.set(about.text_value(), *answer.set) : after.beliefs.raise(about.text_value()));
  }
  note(after.beliefs.raise(input.symbol));
  return tick;
}

}  // namespace continua
