// Words and a gesture that were made together: the automaton may take both as one move (automaton/FORMAT.md,
// Understanding).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/pipeline/engine.h"

namespace continua {

/// The words' input, if a gesture was made with them; the gesture's input comes before it.
inline constexpr const char* together_symbol = "together";

/// The input of a gesture that was made with words, `beside α` for the symbol `gesture α`.
std::string beside_symbol(std::string_view gesture_symbol);

/// Whether the machine takes a gesture of this symbol beside words in the state that the dialogue is in.
bool goes_with_words(const Engine& engine, const EngineState& state, std::string_view gesture_symbol);

/// Offers the first ensemble to attend to and its counterpart, words and a gesture, as `beside …` and `together`.
/// Nothing if there is no counterpart, or if the machine does not take `together`: then they are attended to one by
/// one.
std::optional<Tick> attended_together(const Engine& engine, const EngineState& before, const WorldSnapshot& world);

}  // namespace continua
