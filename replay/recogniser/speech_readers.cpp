// Whisper, Vosk, PocketSphinx: speech.
#include <algorithm>
#include <sstream>

#include "continua/replay/log/run_brief.h"
#include "continua/replay/recogniser/json_reader.h"
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

// An utterance; its confidence is the mean of the words'. Without a beginning it has no times.
Json speech(const std::string& text, std::optional<double> begin_s, std::optional<double> end_s,
            const std::vector<TimedWord>& words) {
  Json event = Json::object();
  if (begin_s) event["t"] = *begin_s;
  event["kind"] = "speech";
  event["text"] = text;
  if (begin_s && end_s && *end_s >= *begin_s) event["until"] = *end_s;
  double sum = 0;
  std::size_t sure = 0;
  for (const auto& word : words) {
    event["words"].push_back({{"text", word.text}, {"t", word.begin_s}});
    if (word.confidence) sum += *word.confidence, ++sure;
  }
  if (sure > 0) event["confidence"] = std::clamp(sum / static_cast<double>(sure), 0.0, 1.0);
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

class WhisperReader : public JsonReader {
 public:
  using JsonReader::JsonReader;

 private:
  void read_object(const Json& whole, std::size_t line, Recognised& gain) override {
    const auto &segments = member_of(whole, "segments"), &transcription = member_of(whole, "transcription");
    if (!segments.is_array() && !transcription.is_array()) {
      gain.problems.push_back(
          lacks(name(), line, "'segments' (whisper, verbose JSON) or 'transcription' (whisper.cpp -oj)"));
      return;
    }
    for (const auto& segment : segments.is_array() ? segments : transcription) read_segment(segment, gain);
  }

  static void read_segment(const Json& segment, Recognised& gain) {
    const auto said = trimmed_words(text_of(segment, "text"));
    if (said.empty() || said.starts_with('[')) return;  // "[BLANK_AUDIO]"
    const auto& offsets = member_of(segment, "offsets");
    if (!offsets.is_object()) {
      const auto words = words_of(member_of(segment, "words"), "word", "start", "end", "probability");
      gain.events.push_back(speech(said, number_of(segment, "start"), number_of(segment, "end"), words));
      return;
    }
    auto from = number_of(offsets, "from"), to = number_of(offsets, "to");
    for (auto* time : {&from, &to})
      if (*time) **time /= 1000;
    gain.events.push_back(speech(said, from, to, words_of_tokens(member_of(segment, "tokens"))));
  }
};

class VoskReader : public JsonReader {
 public:
  using JsonReader::JsonReader;

 private:
  void read_object(const Json& result, std::size_t line, Recognised& gain) override {
    if (result.contains("partial")) return read_partial(result, gain);
    partial_.clear();
    const auto& alternatives = member_of(result, "alternatives");
    const bool many = alternatives.is_array() && !alternatives.empty();
    const Json& best = many ? alternatives[0] : result;
    if (!best.contains("text")) {
      gain.problems.push_back(lacks(name(), line, "'text', 'alternatives' or 'partial', as Vosk's Result() has them"));
      return;
    }
    const auto said = trimmed_words(text_of(best, "text"));
    if (said.empty()) return;  // silence
    const auto words = words_of(member_of(best, "result"), "word", "start", "end", "conf");
    auto event = words.empty() ? speech(said, std::nullopt, std::nullopt, words)
                               : speech(said, words.front().begin_s, words.back().end_s, words);
    if (many) put_alternatives(alternatives, event);
    gain.events.push_back(std::move(event));
  }

  // Words that may still change: those that were told already are not told again.
  void read_partial(const Json& result, Recognised& gain) {
    auto said = trimmed_words(text_of(result, "partial"));
    if (said == partial_) return;
    partial_ = std::move(said);
    if (partial_.empty()) return;
    gain.events.push_back({{"kind", "speech"}, {"text", partial_}, {"final", false}});
  }

  // Their confidences are scores of any size: each counts by its share of the best one's.
  static void put_alternatives(const Json& alternatives, Json& event) {
    const auto most = number_of(alternatives[0], "confidence").value_or(1);
    event.erase("confidence");
    for (const auto& other : alternatives) {
      const auto score = number_of(other, "confidence").value_or(0);
      event["alternatives"].push_back({{"text", trimmed_words(text_of(other, "text"))},
                                       {"confidence", most > 0 ? std::clamp(score / most, 0.0, 1.0) : 0.0}});
    }
  }

  std::string partial_;
};

// A line with the utterance and, by -time yes, a line for each word: word, beginning, end, posterior probability.
// Markers and silence are in angle brackets, "(2)" tells another pronunciation, [NOISE] is none.
class PocketsphinxReader : public RecogniserReader {
 public:
  using RecogniserReader::RecogniserReader;

  void read(const OutputPart& part, Recognised& gain) override {
    std::istringstream fields(part.text);
    std::string word, begin, end, probability, more;
    fields >> word >> begin >> end >> probability >> more;
    const auto from = finite_number(begin), to = finite_number(end), sure = finite_number(probability);
    if (!from || !to || !more.empty()) {
      finish(gain);
      // Where the program's own messages are mixed in, those have a colon.
      if (part.text.find(':') == std::string::npos) said_ = trimmed_words(part.text);
      if (is_untimed()) finish(gain);
      return;
    }
    if (is_untimed()) return;
    if (word.starts_with('<') || word.starts_with('[')) return;
    words_.push_back({word.substr(0, word.find('(')), *from, *to, sure});
    if (text() == said_) finish(gain);
  }

  void finish(Recognised& gain) override {
    if (!words_.empty())
      gain.events.push_back(speech(text(), words_.front().begin_s, words_.back().end_s, words_));
    else if (!said_.empty())
      gain.events.push_back(speech(said_, std::nullopt, std::nullopt, {}));
    words_.clear();
    said_.clear();
  }

 private:
  std::string text() const {
    std::string all;
    for (const auto& word : words_) all += (all.empty() ? "" : " ") + word.text;
    return all;
  }

  std::string said_;  // the utterance whose words come next
  std::vector<TimedWord> words_;
};

}  // namespace

std::unique_ptr<RecogniserReader> whisper_reader(OutputSource source) {
  return std::make_unique<WhisperReader>(std::move(source));
}
std::unique_ptr<RecogniserReader> vosk_reader(OutputSource source) {
  return std::make_unique<VoskReader>(std::move(source));
}
std::unique_ptr<RecogniserReader> pocketsphinx_reader(OutputSource source) {
  return std::make_unique<PocketsphinxReader>(std::move(source));
}

}  // namespace continua
