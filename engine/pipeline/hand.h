// Follows the human's hand sample by sample. Pointing at another object is a move, but the automaton is not offered it.
#pragma once

#include "continua/pipeline/engine.h"

namespace continua {

/// `Understood` if the sample points at another object than the latest one, or comes after a pause. Nothing for other
/// events, for pointing off the table, and for a machine without a lexicon.
Tick follow_hand(const Engine& engine, EngineState state, const InputEvent& sample, int serial,
                 const WorldSnapshot& world);

}  // namespace continua
