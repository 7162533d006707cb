// Reads an utterance: the cheapest sequence of fragments that covers the words, each with its readings.
#pragma once

#include <string_view>

#include "continua/language/reading.h"
#include "continua/language/vocabulary.h"

namespace continua {

/// Words that are read of one utterance; later words are cut off.
inline constexpr std::size_t most_words = 200;
/// Readings that a fragment has at most.
inline constexpr std::size_t most_readings = 6;

/// Reads any text; words that no fragment covers are listed in `unknown` and `unused`.
Utterance read(std::string_view text, const Vocabulary& vocabulary);

}  // namespace continua
