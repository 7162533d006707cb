#include "perception/speech_times.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace continua {
namespace {

// In lower case, letters, digits and what is beyond ASCII alone: recognisers and readers punctuate differently.
std::string bare(const std::string& word) {
  std::string out;
  for (const char c : word) {
    if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80) out += c;
  }
  return out;
}

SimTime usual_time(std::size_t words) { return SimTime::from_seconds(seconds_per_word * static_cast<double>(words)); }

// When each of the words began, where the event tells it; never earlier than the one before.
std::vector<std::optional<SimTime>> told_times(const InputEvent& speech, const std::vector<std::string>& bare_words) {
  std::vector<std::string> told;
  for (const auto& word : speech.words) told.push_back(bare(word.text));
  std::vector<std::optional<SimTime>> times(bare_words.size());
  SimTime latest = speech.t;
  auto from = told.begin();
  for (std::size_t i = 0; i < bare_words.size(); ++i) {
    const auto found = bare_words[i].empty() ? told.end() : std::find(from, told.end(), bare_words[i]);
    if (found == told.end()) continue;
    latest = std::max(latest, speech.words[static_cast<std::size_t>(found - told.begin())].t);
    times[i] = latest;
    from = found + 1;
  }
  return times;
}

}  // namespace

std::vector<TimeSpan> word_times(const InputEvent& speech, const std::vector<std::string>& words) {
  std::vector<std::string> bare_words;
  for (const auto& word : words) bare_words.push_back(bare(word));
  const auto told = told_times(speech, bare_words);
  std::vector<TimeSpan> times(words.size());
  SimTime from = speech.t;
  for (std::size_t i = 0; i < words.size();) {
    // The stretch to the next word whose time is told, or to the end, is spread.
    std::size_t next = i + 1, length = bare_words[i].size(), spoken = bare_words[i].empty() ? 0 : 1;
    for (; next < words.size() && !told[next]; ++next) {
      length += bare_words[next].size();
      if (!bare_words[next].empty()) ++spoken;
    }
    if (told[i]) from = *told[i];
    SimTime until = next < words.size() ? *told[next] : speech.until.value_or(from + usual_time(spoken));
    if (told[i]) until = std::min(until, from + usual_time(2 * spoken));
    until = std::max(from, until);
    const auto at = [&](std::size_t before) {
      const double share = static_cast<double>(before) / static_cast<double>(length);
      return from + SimTime::from_seconds((until - from).seconds() * share);
    };
    for (std::size_t before = 0; i < next; before += bare_words[i++].size())
      times[i] = length == 0 ? TimeSpan{from, until} : TimeSpan{at(before), at(before + bare_words[i].size())};
    from = until;
  }
  return times;
}

TimeSpan time_of(const InputEvent& speech, const std::vector<std::string>& words) {
  const auto times = word_times(speech, words);
  SimTime until = speech.until.value_or(speech.t);
  if (!speech.until)
    for (const auto& each : times) until = std::max(until, each.until);
  return {speech.t, std::max(speech.t, until)};
}

}  // namespace continua
