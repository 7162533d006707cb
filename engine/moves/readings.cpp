#include "continua/moves/readings.h"

#include <utility>

#include "continua/perception/speech_times.h"

namespace continua {
namespace {

ReadSpeech read_speech(InputEvent event, const Understanding& understanding) {
  ReadSpeech speech;
  speech.utterance = understanding.read(event.text);
  const auto times = word_times(event, speech.utterance.words);
  for (const auto& [words, needs] : understanding.demonstratives(speech.utterance)) {
    speech.demonstratives.push_back(words);
    speech.takers.push_back({times[words.begin].from, times[words.end - 1].until, needs});
  }
  speech.event = std::move(event);
  return speech;
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

std::vector<ShownWords> shown_words(const ReadSpeech& speech, const Ensemble& ensemble, const FusionWindow& window) {
  std::vector<Deixis> pointings;
  for (const auto& one : ensemble.bound)
    if (one) pointings.push_back(*one);
  const auto assigned = assign(speech.takers, pointings, window);
  std::vector<ShownWords> shown;
  for (std::size_t i = 0; i < assigned.size(); ++i)
    if (assigned[i]) shown.push_back({speech.demonstratives[i], pointings[*assigned[i]]});
  return shown;
}

}  // namespace continua
