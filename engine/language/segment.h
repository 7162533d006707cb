// A part of an utterance without sentence ends and unknown words: its fragments with their readings.
#pragma once

#include <cstddef>
#include <vector>

#include "continua/language/chart.h"

namespace continua {

/// The most readings that a fragment keeps.
inline constexpr std::size_t most_readings = 6;

/// Adds the cheapest sequence of fragments that covers `words`, and the words that fit nowhere. `positions`: the place
/// of each word among the utterance's words.
void read_segment(const std::vector<Chart::Word>& words, const std::vector<std::size_t>& positions,
                  const Vocabulary& vocabulary, Utterance& utterance);

}  // namespace continua
