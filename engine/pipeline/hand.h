// The human's hand, followed sample by sample: pointing at something else than before is a move, though none that the
// automaton is offered.
#pragma once

#include "continua/pipeline/engine.h"

namespace continua {

/// `Understood` if the sample points at another object than the latest one, or after a pause. Nothing for other events,
/// for samples off the table, and for a machine without a lexicon.
Tick follow_hand(const Engine& engine, EngineState state, const InputEvent& sample, int serial,
                 const WorldSnapshot& world);

}  // namespace continua
