#include "continua/replay/pictures/subtitles.h"

#include <algorithm>

#include "continua/replay/log/reading_time.h"

namespace continua {
namespace {

constexpr std::size_t most_of_a_speaker = 2;

SimTime shown_time(const StoryLine& line) { return line.gesture ? gesture_time : reading_time(line.text); }

}  // namespace

std::vector<Subtitle> subtitles_of(const RunStory& story) {
  std::vector<Subtitle> subtitles;
  for (const auto& line : story.lines) {
    if (line.text.empty()) continue;
    // Only the last of this speaker can still be there: each ends the one before, unless both began together.
    for (auto& other : subtitles) {
      if (other.speaker == line.speaker && other.from < line.from && other.until > line.from &&
          (!line.gesture || other.text.starts_with('[')))
        other.until = line.from;
    }
    subtitles.push_back({line.speaker, line.text, line.from, std::max(line.until, line.from + shown_time(line))});
  }
  return subtitles;
}

std::vector<Subtitle> shown_at(const std::vector<Subtitle>& subtitles, SimTime t) {
  std::vector<Subtitle> shown;
  for (const auto speaker : {Speaker::human, Speaker::avatar}) {
    std::vector<Subtitle> of_speaker;
    for (const auto& one : subtitles)
      if (one.speaker == speaker && one.from <= t && t < one.until) of_speaker.push_back(one);
    // Words matter more than a gesture at the same time.
    std::stable_sort(of_speaker.begin(), of_speaker.end(), [](const Subtitle& a, const Subtitle& b) {
      return !a.text.starts_with('[') && b.text.starts_with('[');
    });
    if (of_speaker.size() > most_of_a_speaker) of_speaker.resize(most_of_a_speaker);
    for (std::size_t i = 1; i < of_speaker.size(); ++i) of_speaker[0].text += " " + of_speaker[i].text;
    if (!of_speaker.empty()) shown.push_back(of_speaker[0]);
  }
  return shown;
}

}  // namespace continua
