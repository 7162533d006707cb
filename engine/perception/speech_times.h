// When the words of an utterance were said: as far as the recogniser tells, estimated where it does not.
#pragma once

#include <string>
#include <vector>

#include "perception/input_event.h"

namespace continua {

/// How long a word takes where nothing tells it: about 170 words a minute, a common rate of conversation in English.
/// Short turns, as commands are, are rather slower than long ones (Yuan, Liberman & Cieri, Interspeech 2006).
inline constexpr double seconds_per_word = 0.35;

struct TimeSpan {
  SimTime from, until;
};

/// When each of `words`, the utterance as its reader divided it, was said; in order, from the event's `t` on.
///   with `words`  those that are found among the event's, in order, begin when they did and end when the next begins,
///                 but take at most twice the usual time; others are spread between them
///   with `until`  spread from the beginning to the end, each in proportion to its length in characters
///   with neither  the same, as if the whole took the usual time
/// A word without letters or digits, a comma, takes no time.
std::vector<TimeSpan> word_times(const InputEvent& speech, const std::vector<std::string>& words);

/// When the whole was said: to `until`, else to the end of the last of `words`.
TimeSpan time_of(const InputEvent& speech, const std::vector<std::string>& words);

}  // namespace continua
