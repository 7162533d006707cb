// The stage of the automaton: one step under the policy of the run.
#pragma once

#include <span>
#include <vector>

#include "continua/pipeline/engine.h"

namespace continua {

/// The symbol of the input that follows an input which was refused.
inline constexpr const char* refused_symbol = "refused";

struct Stepped {
  EngineState after;
  std::vector<StepEvent> events;    ///< of the configuration that decides the avatar's behaviour
  std::vector<EngineEvent> others;  ///< under `explore`: of the other branches
  std::size_t taken = 0;            ///< number of the input taken, or 0
};

/// The first step of a run, before any input.
Stepped first_step(const Engine& engine, EngineState state, const WorldSnapshot& world);

/// Offers inputs of which one is taken. Inputs that the machine ignores, or that are below its minimum confidence, are
/// not offered; nothing happens if none is left.
Stepped step(const Engine& engine, EngineState state, std::span<const Input> inputs, const WorldSnapshot& world);

}  // namespace continua
