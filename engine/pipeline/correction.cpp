#include "continua/pipeline/correction.h"

#include <algorithm>
#include <utility>

#include "continua/moves/inputs.h"
#include "continua/pipeline/believe.h"
#include "continua/pipeline/perceive.h"

namespace continua {
namespace {

Input input_of(const Engine& engine, const EngineState& before, const InputEvent& event,
               const ObservedMoves& observed) {
  Input input = to_input(event, 0);
  input.symbol = symbol_of(engine, before, event);
  input.now_s = event.t.seconds();
  input.observed_gestures = Term::list(observed.gestures, Type::term());
  input.observed_acts = Term::list(observed.acts, Type::term());
  if (!observed.said.empty()) input.observed_speech = Term::text(observed.said.back());
  return input;
}

// The state before the input, with beliefs that have heard the input and the words of the other avatar.
EngineState with_heard(const Engine& engine, const EngineState& before, EngineState state, const Input& input,
                       const std::vector<std::string>& said, const WorldSnapshot& world) {
  state.beliefs = before.beliefs;
  state.configuration = before.configuration;
  state = believe(engine, std::move(state), input, world).after;
  state.last_utterance = before.last_utterance;
  for (const auto& words : said) {
    state.beliefs.overhear(words);
    state.last_utterance = words;
  }
  return state;
}

}  // namespace

Tick correct(const Engine& engine, const EngineState& before, const EngineState& after, const InputEvent& event,
             const ObservedMoves& observed, const WorldSnapshot& world) {
  const Input input = input_of(engine, before, event, observed);
  Tick tick{with_heard(engine, before, after, input, observed.said, world), {}};
  EngineState& state = tick.after;
  for (auto& change : state.beliefs.changes_since(after.beliefs)) tick.events.push_back(std::move(change));
  state.configuration.memory = after.configuration.memory;
  state.configuration.next = after.configuration.next;

  const Facts facts = facts_of(state, world);
  const auto applies = [&](const Implied& row) {
    return !row.when || engine.stepper.value(*row.when, state.configuration, input, facts).value.is_true();
  };
  const bool silent = observed.said.empty() && observed.gestures.empty() && observed.acts.empty();
  const auto& rows = engine.machine->implied;
  const auto implied = silent ? rows.end() : std::find_if(rows.begin(), rows.end(), applies);
  if (!silent && implied == rows.end()) {
    state.configuration = after.configuration;
    return tick;
  }
  std::vector<StepEvent> account;
  if (!silent) state.configuration = engine.stepper.implied(*implied, state.configuration, input, facts, &account);
  for (auto& step : account) tick.events.push_back(std::move(step));
  tick.events.push_back(Corrected{after.configuration.state, state.configuration.state, silent ? 0 : implied->number,
                                  state.configuration.stack.id(), state.configuration.stack.depth()});
  return tick;
}

}  // namespace continua
