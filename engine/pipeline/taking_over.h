// Takes over a run that another pipeline has begun.
#pragma once

#include "continua/core/result.h"
#include "continua/pipeline/engine.h"

namespace continua {

/// `Pipeline::take_over`: translates the state for this engine's machine, by names. Errors: a taught word that means
/// something else in this machine, and those of automaton/carry_over.h.
Result<EngineState> taken_over(const Engine& engine, EngineState state, const Machine& was, const WorldSnapshot& world);

}  // namespace continua
