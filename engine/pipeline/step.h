// The stage of the automaton: one step under the policy of the run.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "continua/pipeline/engine.h"

namespace continua {

/// The symbol of the input that follows an input which was refused.
inline constexpr const char* refused_symbol = "refused";
/// The symbol of an input that the recogniser is not sure of, offered before the input itself.
inline constexpr const char* unsure_symbol = "unsure";

struct Stepped {
  EngineState after;
  std::vector<StepEvent> events;    ///< of the configuration that decides the avatar's behaviour
  std::vector<EngineEvent> others;  ///< under `explore`: of the other branches
  std::size_t taken = 0;            ///< number of the input taken, or 0
};

/// The first step of a run, before any input.
Stepped first_step(const Engine& engine, EngineState state, const WorldSnapshot& world);

/// The reason why an input of this confidence is not to count; nothing if it is to. Without a symbol only the machine's
/// minimum counts.
std::optional<std::string> too_unsure(const Machine& machine, const std::string& symbol, double confidence);

/// Offers inputs of which one is taken. Inputs that the machine ignores, or that are too unsure, are not offered;
/// nothing happens if none is left.
Stepped step(const Engine& engine, EngineState state, std::span<const Input> inputs, const WorldSnapshot& world);

/// The step of an input that is only offered: nothing if no transition takes it.
std::optional<Stepped> step_if_taken(const Engine& engine, EngineState state, const Input& input,
                                     const WorldSnapshot& world);

}  // namespace continua
