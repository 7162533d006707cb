// The automaton as a stage: one step under the policy of the run, whichever that is.
#pragma once

#include <span>
#include <vector>

#include "continua/pipeline/engine.h"

namespace continua {

struct Stepped {
  EngineState after;
  std::vector<StepEvent> events;    ///< of the configuration that the avatar acts by
  std::vector<EngineEvent> others;  ///< under `explore`: the other branches
  std::size_t taken = 0;            ///< which of the inputs was taken, or 0
};

/// The automaton as a run begins.
Stepped first_step(const Engine& engine, EngineState state, const WorldSnapshot& world);

/// Offers inputs of which one counts. An input that the machine ignores, or one below its minimum of confidence, is not
/// offered; nothing happens if none is left.
Stepped step(const Engine& engine, EngineState state, std::span<const Input> inputs, const WorldSnapshot& world);

}  // namespace continua
