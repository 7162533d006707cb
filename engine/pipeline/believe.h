// The stage of beliefs: an input raises or lowers certainties by the machine's table.
#pragma once

#include "continua/pipeline/engine.h"

namespace continua {

/// A `BeliefChange` for each certainty that the input changes.
Tick believe(const Engine& engine, EngineState state, const Input& input, const WorldSnapshot& world);

}  // namespace continua
