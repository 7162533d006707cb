// The stage of perception: an event becomes a percept with its readings, the words that pointing can go with, and the
// place where a gesture points.
#pragma once

#include <string>

#include "continua/core/result.h"
#include "continua/pipeline/engine.h"

namespace continua {

/// The event as a symbol, for the log: speech by its words. Machines with a lexicon know the moves of speech instead.
std::string symbol_of(const Engine& engine, const EngineState& state, const InputEvent& event);

/// A gesture with a shape, by a name: its own, else one that a lesson can be about. The state remembers the shape.
InputEvent with_name(const Engine& engine, EngineState& state, InputEvent event);

/// Speech with its readings. `serial` names the event.
Percept heard(const InputEvent& event, int serial, const Understanding& understanding);

/// `serial` names the event. The error is the sentence of a refusal: the recogniser is not sure enough.
Result<Percept> perceive(const Engine& engine, const EngineState& state, const InputEvent& event, int serial);

}  // namespace continua
