// Follows the human's hand and eyes sample by sample. Pointing at another object is a move, but the automaton is not
// offered it; a look only makes its object more salient.
#pragma once

#include "continua/pipeline/engine.h"

namespace continua {

/// `Understood` if the sample points at another object than the latest one, or comes after a pause. Nothing for other
/// events, for pointing off the table, and for a machine without a lexicon.
Tick follow_hand(const Engine& engine, EngineState state, const InputEvent& sample, int serial,
                 const WorldSnapshot& world);

/// `Understood` if the eyes reach another object than the latest one, or come back to it. Nothing for a machine without
/// `gaze` or without a lexicon.
Tick follow_eyes(const Engine& engine, EngineState state, const InputEvent& sample, int serial,
                 const WorldSnapshot& world);

/// The objects that are salient at `now` because the human looked at them.
Looked looked_at(const Engine& engine, const EngineState& state, SimTime now);

}  // namespace continua
