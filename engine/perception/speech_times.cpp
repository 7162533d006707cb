#include "continua/perception/speech_times.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "continua/core/characters.h"
#include "continua/core/words.h"

namespace continua {
namespace {

// A word by its letters alone, for comparison: recognisers and readers punctuate differently.
struct BareWord {
  std::string text;
  std::size_t length = 0;  // in characters
};

BareWord bare(const std::string& word) {
  BareWord one{bare_words(word, "")};
  one.length = characters(one.text).size();
  return one;
}

SimTime usual_time(std::size_t words) { return SimTime::from_seconds(seconds_per_word * static_cast<double>(words)); }

// The reported beginning of each word, if the event has one; never earlier than the word before.
std::vector<std::optional<SimTime>> reported_times(const InputEvent& speech, const std::vector<BareWord>& words) {
  std::vector<std::string> reported;
  for (const auto& word : speech.words) reported.push_back(bare(word.text).text);
  std::vector<std::optional<SimTime>> times(words.size());
  SimTime latest = speech.t;
  auto from = reported.begin();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto found = words[i].length == 0 ? reported.end() : std::find(from, reported.end(), words[i].text);
    if (found == reported.end()) continue;
    latest = std::max(latest, speech.words[static_cast<std::size_t>(found - reported.begin())].t);
    times[i] = latest;
    from = found + 1;
  }
  return times;
}

}  // namespace

std::vector<TimeSpan> word_times(const InputEvent& speech, const std::vector<std::string>& words) {
  std::vector<BareWord> bare_of;
  for (const auto& word : words) bare_of.push_back(bare(word));
  const auto reported = reported_times(speech, bare_of);
  std::vector<TimeSpan> times(words.size());
  SimTime from = speech.t;
  for (std::size_t i = 0; i < words.size();) {
    // The words up to the next word with a reported time, or up to the end, share the time until then.
    std::size_t next = i, length = 0, spoken = 0;
    do {
      length += bare_of[next].length;
      if (bare_of[next].length > 0) ++spoken;
    } while (++next < words.size() && !reported[next]);
    if (reported[i]) from = *reported[i];
    SimTime until = next < words.size() ? *reported[next] : speech.until.value_or(from + usual_time(spoken));
    if (reported[i]) until = std::min(until, from + usual_time(2 * spoken));
    until = std::max(from, until);
    const auto at = [&](std::size_t before) {
      const double share = static_cast<double>(before) / static_cast<double>(length);
      return from + SimTime::from_seconds((until - from).seconds() * share);
    };
    for (std::size_t before = 0; i < next; before += bare_of[i++].length)
      times[i] = length == 0 ? TimeSpan{from, until} : TimeSpan{at(before), at(before + bare_of[i].length)};
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
