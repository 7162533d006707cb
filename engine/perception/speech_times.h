// The time of each word of an utterance: the recogniser's time if it has one, else an estimate.
#pragma once

#include <string>
#include <vector>

#include "continua/perception/input_event.h"

namespace continua {

/// Estimated duration of a word without a reported time: about 170 words a minute, a common rate of conversation. One
/// number serves every language: rates differ less between languages than between speakers, and short turns such as
/// commands are slower than long ones (Yuan, Liberman & Cieri, Interspeech 2006).
inline constexpr double seconds_per_word = 0.35;

struct TimeSpan {
  SimTime from, until;
};

/// Time span of each of `words`, the words as the parser divides them; in order, from the event's `t` on. If the event
/// has
///   `words`  words found among them, in order, begin at their reported time and end when the next begins, but last at
///            most twice the estimate; the words between them share the time between
///   `until`  the words share the time to the end, each in proportion to its length in characters
///   neither  the words share the time in the same way, to an end estimated from the number of words
/// A word without letters or digits, such as a comma, takes no time.
std::vector<TimeSpan> word_times(const InputEvent& speech, const std::vector<std::string>& words);

/// Time span of the whole utterance: to `until`, else to the end of the last of `words`.
TimeSpan time_of(const InputEvent& speech, const std::vector<std::string>& words);

}  // namespace continua
