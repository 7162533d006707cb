#include "continua/moves/readings.h"

#include <algorithm>
#include <utility>

#include "continua/core/words.h"
#include "continua/perception/speech_times.h"

namespace continua {
namespace {

std::string text_of(const Utterance& utterance, WordSpan span) {
  std::string text;
  for (auto word = span.begin; word < span.end; ++word) text += (text.empty() ? "" : " ") + utterance.words[word];
  return text;
}

// The only fragment of words that are understood as a whole; nullptr if they are not.
const Fragment* only_fragment(const Utterance& utterance) {
  const auto& fragments = utterance.fragments;
  return fragments.size() == 1 && fragments[0].words.size() == utterance.words.size() ? &fragments[0] : nullptr;
}

// Whether a noun was read as what is said of the thing before it, and both may be one thing that is pointed at: "is
// this block".
bool ends_in_thing(const ReadSpeech& speech, const Understanding& understanding) {
  static const Type property = Type::function(Type::entity(), Type::truth());
  const auto& utterance = speech.utterance;
  if (utterance.fragments.empty() || speech.demonstratives.empty()) return false;
  const auto end = utterance.fragments.back().words.end;
  const auto& last = speech.demonstratives.back();
  if (!last.needs || last.place || last.words.end >= end) return false;
  const auto noun = understanding.read(text_of(utterance, {last.words.end, end}));
  const auto* said = only_fragment(noun);
  if (!said || !(said->readings.front().term.type() == property)) return false;
  const auto thing = understanding.read(text_of(utterance, {last.words.begin, end}));
  const auto shown = only_fragment(thing) ? understanding.demonstratives(thing) : std::vector<Demonstrative>();
  return shown.size() == 1 && shown[0].needs && shown[0].words.size() == thing.words.size();
}

ReadSpeech read_speech(InputEvent event, const Understanding& understanding) {
  ReadSpeech speech;
  speech.utterance = understanding.read(event.text);
  const auto times = word_times(event, speech.utterance.words);
  speech.demonstratives = understanding.demonstratives(speech.utterance);
  for (const auto& each : speech.demonstratives)
    speech.takers.push_back({times[each.words.begin].from, times[each.words.end - 1].until, each.needs, event.t});
  speech.until = time_of(event, speech.utterance.words).until;
  speech.ends_in_thing = ends_in_thing(speech, understanding);
  speech.event = std::move(event);
  return speech;
}

// The number of things said: moves, and words that belong to none.
std::size_t parts(const Readings& readings) {
  const auto& utterance = readings.alternatives.front().utterance;
  return utterance.fragments.size() + utterance.unknown.size() + utterance.unused.size();
}

bool is_whole(const Fragment& fragment) {
  const auto& term = fragment.readings.front().term;
  return term.closed() && term.type() == Type::truth();
}

// Whether the last words of the speech need a pointing: after the finger more words may come.
bool ends_in_pointing(const ReadSpeech& speech) {
  if (speech.demonstratives.empty()) return false;
  const auto& last = speech.demonstratives.back();
  return last.needs && last.words.end == speech.utterance.words.size();
}

}  // namespace

std::shared_ptr<const Readings> readings_of(const InputEvent& speech, const Understanding& understanding,
                                            std::shared_ptr<const Readings> known) {
  if (known && known->words == understanding.words()) return known;
  Readings readings{understanding.words(), {}};
  for (std::size_t k = 0; k <= speech.alternatives.size(); ++k)
    readings.alternatives.push_back(read_speech(alternative(speech, k), understanding));
  return std::make_shared<const Readings>(std::move(readings));
}

bool is_unfinished(const ReadSpeech& speech) {
  const auto spoken = words_of(speech.event.text);
  if (spoken.empty() || (spoken.back().ends_after && !spoken.back().half)) return false;
  const auto& utterance = speech.utterance;
  if (utterance.cut) return false;
  if (utterance.fragments.empty() || !is_whole(utterance.fragments.back())) return true;
  if (speech.ends_in_thing || ends_in_pointing(speech)) return true;
  const auto& ends = utterance.ends;
  const std::size_t begin = ends.size() < 2 ? 0 : ends[ends.size() - 2];
  const auto is_last = [begin](std::size_t word) { return word >= begin; };
  const auto has_last = [&](const std::vector<std::size_t>& words) {
    return std::any_of(words.begin(), words.end(), is_last);
  };
  return has_last(utterance.unknown) || has_last(utterance.unused);
}

bool reads_as_one(const Readings& first, const Readings& second, const Readings& whole) {
  const auto before = parts(first), after = parts(second), together = parts(whole);
  return together < before + after || (before == 0 && together == after);
}

std::vector<ShownWords> shown_words(const ReadSpeech& speech, const Ensemble& ensemble, const FusionWindow& window) {
  std::vector<Deixis> pointings;
  for (const auto& one : ensemble.bound)
    if (one) pointings.push_back(*one);
  const auto assigned = assign(speech.takers, pointings, window);
  std::vector<ShownWords> shown;
  for (std::size_t i = 0; i < assigned.size(); ++i)
    if (assigned[i]) shown.push_back({speech.demonstratives[i].words, pointings[*assigned[i]]});
  return shown;
}

}  // namespace continua
