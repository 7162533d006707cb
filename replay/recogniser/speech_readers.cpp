// Whisper, Vosk, PocketSphinx: speech.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "continua/replay/log/run_brief.h"
#include "continua/replay/recogniser/json_values.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "continua/replay/trace/session_notation.h"

namespace continua {
namespace {

struct TimedWord {
  std::string text;
  double begin_s = 0, end_s = 0;
  std::optional<double> confidence;
};

// The words of a list, with the names that the format has for their members.
std::vector<TimedWord> words_of(const Json& list, const char* text, const char* begin, const char* end,
                                const char* confidence) {
  std::vector<TimedWord> words;
  if (!list.is_array()) return words;
  for (const auto& one : list) {
    auto word = trimmed_words(text_of(one, text));
    if (const auto from = number_of(one, begin); from && !word.empty())
      words.push_back({std::move(word), *from, number_of(one, end).value_or(*from), number_of(one, confidence)});
  }
  return words;
}

// An utterance; its confidence is its own, else the mean of the words'.
Json speech(const std::string& text, double begin_s, std::optional<double> end_s, const std::vector<TimedWord>& words,
            std::optional<double> confidence) {
  Json event = {{"t", begin_s}, {"kind", "speech"}, {"text", text}};
  if (end_s && *end_s >= begin_s) event["until"] = *end_s;
  double sum = 0;
  std::size_t sure = 0;
  for (const auto& word : words) {
    event["words"].push_back({{"text", word.text}, {"t", word.begin_s}});
    if (word.confidence) sum += *word.confidence, ++sure;
  }
  if (!confidence && sure > 0) confidence = sum / static_cast<double>(sure);
  if (confidence) event["confidence"] = std::clamp(*confidence, 0.0, 1.0);
  return event;
}

// Tokens of whisper.cpp are pieces of words: those that begin with a blank begin a word; names in brackets are no
// words.
std::vector<TimedWord> words_of_tokens(const Json& tokens) {
  std::vector<TimedWord> words;
  if (!tokens.is_array()) return words;
  for (const auto& token : tokens) {
    const auto text = text_of(token, "text");
    const auto& offsets = member_of(token, "offsets");
    const auto from = number_of(offsets, "from"), to = number_of(offsets, "to");
    if (!from || !to || text.empty() || text.starts_with('[')) continue;
    if (words.empty() || text.starts_with(' '))
      words.push_back({trimmed_words(text), *from / 1000, *to / 1000, number_of(token, "p")});
    else
      words.back().text += text, words.back().end_s = *to / 1000;
  }
  std::erase_if(words, [](const TimedWord& word) { return word.text.empty(); });
  return words;
}

}  // namespace

Result<std::vector<Json>> read_whisper(std::string_view text, const std::string& name) {
  const auto objects = objects_in(text, name);
  if (!objects) return objects.error();
  std::vector<Json> events;
  for (const auto& [whole, line] : *objects) {
    const auto &segments = member_of(whole, "segments"), &transcription = member_of(whole, "transcription");
    if (!segments.is_array() && !transcription.is_array())
      return lacks(name, line, "'segments' (whisper, verbose JSON) or 'transcription' (whisper.cpp -oj)");
    for (const auto& segment : segments.is_array() ? segments : transcription) {
      const auto& offsets = member_of(segment, "offsets");
      const bool cpp = offsets.is_object();
      const auto begin = cpp ? number_of(offsets, "from") : number_of(segment, "start");
      const auto end = cpp ? number_of(offsets, "to") : number_of(segment, "end");
      const auto said = trimmed_words(text_of(segment, "text"));
      if (!begin || said.empty() || said.starts_with('[')) continue;  // "[BLANK_AUDIO]"
      const double unit = cpp ? 1000 : 1;
      const auto words = cpp ? words_of_tokens(member_of(segment, "tokens"))
                             : words_of(member_of(segment, "words"), "word", "start", "end", "probability");
      events.push_back(speech(said, *begin / unit, end ? std::optional(*end / unit) : end, words, std::nullopt));
    }
  }
  return events;
}

Result<std::vector<Json>> read_vosk(std::string_view text, const std::string& name) {
  const auto objects = objects_in(text, name);
  if (!objects) return objects.error();
  std::vector<Json> events;
  for (const auto& [result, line] : *objects) {
    if (result.contains("partial")) continue;  // without a time
    const auto& alternatives = member_of(result, "alternatives");
    const bool many = alternatives.is_array() && !alternatives.empty();
    const Json& best = many ? alternatives[0] : result;
    if (!best.contains("text"))
      return lacks(name, line, "'text', 'alternatives' or 'partial', as Vosk's Result() has them");
    const auto words = words_of(member_of(best, "result"), "word", "start", "end", "conf");
    if (words.empty()) continue;  // silence, or SetWords(True) was not called
    auto event =
        speech(trimmed_words(text_of(best, "text")), words.front().begin_s, words.back().end_s, words, std::nullopt);
    if (many) {
      // Their confidences are scores of any size: each counts by its share of the best one's.
      const auto most = number_of(best, "confidence").value_or(1);
      event.erase("confidence");
      for (const auto& other : alternatives) {
        const auto score = number_of(other, "confidence").value_or(0);
        event["alternatives"].push_back({{"text", trimmed_words(text_of(other, "text"))},
                                         {"confidence", most > 0 ? std::clamp(score / most, 0.0, 1.0) : 0.0}});
      }
    }
    events.push_back(std::move(event));
  }
  return events;
}

// Blocks of a line with the utterance and a line for each word: word, beginning, end, posterior probability. Markers
// are in angle brackets, "(2)" tells another pronunciation, [NOISE] is none.
Result<std::vector<Json>> read_pocketsphinx(std::string_view text, const std::string& name) {
  std::vector<Json> events;
  std::vector<TimedWord> words;
  const auto finish = [&] {
    std::string said;
    for (const auto& word : words) said += (said.empty() ? "" : " ") + word.text;
    if (!words.empty()) events.push_back(speech(said, words.front().begin_s, words.back().end_s, words, std::nullopt));
    words.clear();
  };
  std::istringstream lines{std::string(text)};
  bool timed = false;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    std::string word, begin, end, probability, more;
    parts >> word >> begin >> end >> probability >> more;
    const auto from = finite_number(begin), to = finite_number(end), sure = finite_number(probability);
    if (!from || !to || !more.empty()) {
      finish();
      continue;
    }
    timed = true;
    if (word.starts_with('<') || word.starts_with('[')) continue;
    words.push_back({word.substr(0, word.find('(')), *from, *to, sure});
  }
  finish();
  if (!timed)
    return lacks(name, 1, "lines of word, beginning, end and probability, as pocketsphinx -time yes prints them");
  return events;
}

}  // namespace continua
