// Where the dialogue is when another avatar was observed to do something else than this one did.
#include "continua/pipeline/inputs.h"
#include "continua/pipeline/pipeline.h"

namespace continua {

Tick Pipeline::corrected(const EngineState& before, const EngineState& after, const InputEvent& event,
                         const ObservedMoves& observed, const WorldSnapshot& world) {
  Tick tick{after, {}};
  EngineState& state = tick.after;
  methods_.see(&world, &state.chooser.random, &state.learned);

  Input input = to_input(event, 0);
  input.symbol = symbol(event, before.learned);
  input.now_s = event.t.seconds();
  input.observed_gestures = Term::list(observed.gestures, Type::term());
  input.observed_acts = Term::list(observed.acts, Type::term());
  if (!observed.said.empty()) input.observed_speech = Term::text(observed.said.back());

  // The input counts as it did; of what was said after it, what was observed.
  state.beliefs = before.beliefs;
  state.configuration = before.configuration;
  std::vector<EngineEvent> known;
  update_beliefs(state, input, known);
  state.last_utterance = before.last_utterance;
  for (const auto& words : observed.said) {
    state.beliefs.overhear(words);
    state.last_utterance = words;
  }
  for (auto& change : state.beliefs.changes_since(after.beliefs)) tick.events.push_back(std::move(change));
  state.configuration.memory = after.configuration.memory;
  state.configuration.next_symbol = after.configuration.next_symbol;

  const bool silent = observed.said.empty() && observed.gestures.empty() && observed.acts.empty();
  const Implied* implied = nullptr;
  if (!silent)
    for (const auto& row : machine_->implied)
      if (!row.when || stepper_.value(*row.when, state.configuration, input, state.beliefs).value.is_true()) {
        implied = &row;
        break;
      }
  if (!silent && !implied) {
    state.configuration = after.configuration;
    return tick;
  }
  std::vector<StepEvent> account;
  if (implied) state.configuration = stepper_.implied(*implied, state.configuration, input, state.beliefs, &account);
  for (auto& step : account) tick.events.push_back(std::move(step));
  tick.events.push_back(Corrected{after.configuration.state, state.configuration.state, implied ? implied->number : 0,
                                  state.configuration.stack.id(), state.configuration.stack.depth()});
  return tick;
}

}  // namespace continua
