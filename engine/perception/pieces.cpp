#include "continua/perception/pieces.h"

#include <algorithm>
#include <utility>

#include "continua/core/words.h"
#include "continua/perception/speech_times.h"

namespace continua {
namespace {

std::vector<std::string> spoken(const InputEvent& speech) {
  std::vector<std::string> words;
  for (auto& word : words_of(speech.text))
    if (!word.comma) words.push_back(std::move(word.text));
  return words;
}

void add_words(const InputEvent& speech, std::vector<Word>& timed) {
  const auto words = spoken(speech);
  const auto times = word_times(speech, words);
  for (std::size_t i = 0; i < words.size(); ++i) timed.push_back({words[i], times[i].from});
}

}  // namespace

InputEvent joined(const InputEvent& first, const InputEvent& second) {
  const auto both = [](const std::string& a, const std::string& b) { return a + " " + b; };
  InputEvent whole = first;
  whole.text = both(first.text, second.text);
  whole.confidence = std::min(first.confidence, second.confidence);
  whole.until = time_of(second, spoken(second)).until;
  whole.words.clear();
  add_words(first, whole.words);
  add_words(second, whole.words);
  whole.alternatives.clear();
  for (const auto& [text, confidence] : first.alternatives)
    whole.alternatives.push_back({both(text, second.text), std::min(confidence, second.confidence)});
  for (const auto& [text, confidence] : second.alternatives)
    whole.alternatives.push_back({both(first.text, text), std::min(confidence, first.confidence)});
  if (whole.alternatives.size() > most_alternatives) whole.alternatives.resize(most_alternatives);
  return whole;
}

}  // namespace continua
