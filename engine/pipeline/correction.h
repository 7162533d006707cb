// The stage of correction: the dialogue follows another avatar that was observed to make other moves.
#pragma once

#include "continua/pipeline/engine.h"

namespace continua {

/// `Pipeline::corrected`, for an engine that went from `before` to `after` at the event.
Tick correct(const Engine& engine, const EngineState& before, const EngineState& after, const InputEvent& event,
             const ObservedMoves& observed, const WorldSnapshot& world);

}  // namespace continua
