// When each word of an utterance was spoken: the recogniser's times where there are any, estimates elsewhere.
#pragma once

#include <string>
#include <vector>

#include "continua/perception/input_event.h"

namespace continua {

/// Estimated duration of a word without a reported time: about 170 words a minute, a common rate of conversation. Rates
/// of languages differ less than those of speakers, and short turns such as commands are rather slower than long ones
/// (Yuan, Liberman & Cieri, Interspeech 2006); so one number serves every language.
inline constexpr double seconds_per_word = 0.35;

struct TimeSpan {
  SimTime from, until;
};

/// Time span of each of `words`, the utterance as its reader divided it; in order, from the event's `t` on.
///   with `words`  words found among the event's, in order, begin at their reported time and end when the next begins,
///                 but last at most twice the estimate; the words between them share the time between
///   with `until`  the words share the time to the end, each in proportion to its length in characters
///   with neither  the same, to an end estimated from the number of words
/// A word without letters or digits, such as a comma, takes no time.
std::vector<TimeSpan> word_times(const InputEvent& speech, const std::vector<std::string>& words);

/// Time span of the whole utterance: to `until`, else to the end of the last of `words`.
TimeSpan time_of(const InputEvent& speech, const std::vector<std::string>& words);

}  // namespace continua
