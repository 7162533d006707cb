// The subtitles in a picture of a run at an instant: speaker and words, each long enough to be read.
#pragma once

#include <vector>

#include "continua/replay/pictures/run_story.h"

namespace continua {

struct Subtitle {
  Speaker speaker = Speaker::human;
  std::string text;
  SimTime from{}, until{};  ///< shown at from ≤ t < until
};

/// In order of time. A line stays for as long as it is said and as it takes to read it, but goes when the same speaker
/// says another; gestures give way to speech and are short.
std::vector<Subtitle> subtitles_of(const RunStory& story);

/// The subtitles at `t`: at most one for each speaker, the human's first; the human's words and gesture are put
/// together.
std::vector<Subtitle> shown_at(const std::vector<Subtitle>& subtitles, SimTime t);

}  // namespace continua
