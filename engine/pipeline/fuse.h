// The stage of fusion: percepts wait for their counterparts and become ensembles.
#pragma once

#include "continua/core/result.h"
#include "continua/pipeline/engine.h"

namespace continua {

/// The fusion before the first event. Pointings far from the table are not believed.
Fusion first_fusion(const Engine& engine, const WorldSnapshot& world);

/// The state after a percept has arrived at `now`. The error is the sentence of a refusal: the percept came too late.
Result<EngineState> fuse(const Engine& engine, EngineState state, Percept percept, SimTime now);

/// The state with all ensembles that are complete at `now` in EngineState::complete.
EngineState released(const Engine& engine, EngineState state, SimTime now);
/// The state with all waiting percepts in EngineState::complete.
EngineState released_all(const Engine& engine, EngineState state);

/// Takes the first of EngineState::complete, read with the words that are known now. REQUIRES that there is one.
Ensemble take_complete(const Engine& engine, EngineState& state);

}  // namespace continua
