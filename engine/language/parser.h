// Reads an utterance: the cheapest sequence of fragments that covers the words, each with its readings.
#pragma once

#include <string_view>

#include "continua/language/reading.h"
#include "continua/language/vocabulary.h"

namespace continua {

/// The words of an utterance that are read; further ones are cut.
inline constexpr std::size_t most_words = 200;

/// Reads any text. Words that are not understood are listed in `unknown` and `unused`, misheard ones in `repaired`.
/// Where a sentence has any, its longest fragment alone is kept: pieces of what was not understood are no moves.
Utterance read(std::string_view text, const Vocabulary& vocabulary);

}  // namespace continua
