// Words and a gesture that were made together: the automaton may take both as one move (automaton/FORMAT.md,
// Understanding).
#pragma once

#include <optional>

#include "continua/pipeline/engine.h"

namespace continua {

/// The gesture's input, if words were made with it, and the words' input after it.
inline constexpr const char* beside_symbol = "beside";
inline constexpr const char* together_symbol = "together";

/// Offers the first ensemble to attend to and its counterpart, words and a gesture, as `beside` and `together`. Nothing
/// if there is no counterpart, or if the machine does not take `together`: then they are attended to one by one.
std::optional<Tick> attended_together(const Engine& engine, const EngineState& before, const WorldSnapshot& world);

}  // namespace continua
