// Beliefs as a stage: an input raises or lowers certainties, as the machine says.
#pragma once

#include "continua/pipeline/engine.h"

namespace continua {

/// A `BeliefChange` for each certainty that is another one after the input.
Tick believe(const Engine& engine, EngineState state, const Input& input, const WorldSnapshot& world);

}  // namespace continua
