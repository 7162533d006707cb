#include "continua/pipeline/perceive.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "continua/moves/kind.h"

namespace continua {
namespace {

bool is_confident(const InputEvent& event, double least) {
  return event.confidence >= least || std::any_of(event.alternatives.begin(), event.alternatives.end(),
                                                  [&](const Alternative& one) { return one.confidence >= least; });
}

}  // namespace

std::string symbol_of(const Engine& engine, const EngineState& state, const InputEvent& event) {
  return symbol_of(event, gestures_of(engine), state.learned);
}

InputEvent with_name(const Engine& engine, EngineState& state, InputEvent event) {
  if (event.modality != Modality::gesture || event.features.empty() || event.phase == "stop") return event;
  const auto* gestures = gestures_of(engine);
  if (event.name.empty())
    event.name = state.shapes.name_for(event.features, state.learned,
                                       [&](std::string_view name) { return gestures && gestures->find(name); });
  state.shapes.add(event.name, event.features);
  return event;
}

Percept heard(const InputEvent& event, int serial, const Understanding& understanding) {
  Percept percept{serial, event, {}, {}};
  percept.readings = readings_of(event, understanding);
  const auto& speech = percept.readings->alternatives.front();
  percept.takers = speech.takers;
  percept.unfinished = is_unfinished(speech);
  percept.spoken = speech.until;
  return percept;
}

Result<Percept> perceive(const Engine& engine, const EngineState& state, const InputEvent& event, int serial) {
  const double least = engine.machine->minimum_confidence;
  if (!is_confident(event, least))
    return Error{"", fmt::format("confidence {} is below the machine's minimum of {}", event.confidence, least)};
  const auto understanding = understanding_of(engine, state);
  if (event.modality == Modality::speech && understanding) return heard(event, serial, *understanding);
  Percept percept{serial, event, {}, {}};
  if (event.modality == Modality::gesture &&
      kind_of(event, *engine.machine, gestures_of(engine), state.learned) == deixis) {
    // A pointing gesture without a place points where the hand does.
    if (!place_of(event) && state.pointed && goes_on(*state.pointed, event.t, engine.window))
      percept.event.target_W = state.pointed->place_W;
    percept.deixis = deixis_of(percept.event, serial);
  }
  return percept;
}

}  // namespace continua
