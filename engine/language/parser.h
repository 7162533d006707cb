// Reads what was said: the cheapest sequence of fragments that covers the words, each with its readings.
#pragma once

#include <string_view>

#include "continua/language/reading.h"
#include "continua/language/vocabulary.h"

namespace continua {

/// Words that are read of one utterance; what follows them is cut.
inline constexpr std::size_t most_words = 200;
/// Readings that a fragment has at most.
inline constexpr std::size_t most_readings = 6;

/// Any text; what is not understood is told in `unknown` and `unused`.
Utterance read(std::string_view text, const Vocabulary& vocabulary);

}  // namespace continua
