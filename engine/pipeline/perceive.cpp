#include "continua/pipeline/perceive.h"

#include <optional>
#include <utility>

#include "continua/moves/kind.h"
#include "continua/pipeline/step.h"
#include "continua/pipeline/together.h"

namespace continua {
namespace {

// The reason why no alternative of the event is to count; nothing if one is. Of words that are to be read the kind of
// move is not known yet: they are judged once it is.
std::optional<std::string> all_too_unsure(const Engine& engine, const EngineState& state, const InputEvent& event) {
  const bool is_read = event.modality == Modality::speech && event.final && !engine.machine->lexicon.empty();
  std::optional<std::string> first;
  for (std::size_t k = 0; k <= event.alternatives.size(); ++k) {
    const InputEvent one = alternative(event, k);
    auto why = too_unsure(*engine.machine, is_read ? "" : symbol_of(engine, state, one), one.confidence);
    if (!why) return std::nullopt;
    if (!first) first = std::move(why);
  }
  return first;
}

// Whether a gesture of this symbol is made by itself: it is never confirmed, or the machine does not take it with
// words.
bool is_by_itself(const Engine& engine, const EngineState& state, const std::string& symbol) {
  const auto* thresholds = engine.machine->thresholds_of(symbol);
  return engine.machine->ignored.contains(symbol) || (thresholds && thresholds->confirm == 0) ||
         !goes_with_words(engine, state, symbol);
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
  if (auto why = all_too_unsure(engine, state, event)) return Error{"", *std::move(why)};
  const auto understanding = understanding_of(engine, state);
  if (event.modality == Modality::speech && understanding) return heard(event, serial, *understanding);
  Percept percept{serial, event, {}, {}};
  percept.before_words = known_gesture(event, gestures_of(engine), state.learned).comes_before_words();
  if (event.modality == Modality::gesture &&
      kind_of(event, *engine.machine, gestures_of(engine), state.learned) == deixis) {
    // A pointing gesture without a place points where the hand does.
    if (!place_of(event) && state.pointed && goes_on(*state.pointed, event.t, engine.window))
      percept.event.target_W = state.pointed->place_W;
    percept.deixis = deixis_of(percept.event, serial);
    return percept;
  }
  const bool is_gesture = event.modality == Modality::gesture && !event.until;
  if (is_gesture && is_by_itself(engine, state, symbol_of(engine, state, event))) percept.event.until = event.t;
  return percept;
}

}  // namespace continua
