#include "continua/core/words.h"

#include <algorithm>
#include <array>
#include <optional>

#include "continua/core/characters.h"

namespace continua {
namespace {

// Commas and ends of sentences in several scripts: Latin, Greek, Arabic, Devanagari, Chinese and Japanese.
constexpr std::array<std::string_view, 4> commas = {",", "،", "、", "，"};
constexpr std::array<std::string_view, 13> ends = {".", "?", "!", ";", ":", "…", ";", "؟", "؛", "।", "。", "？", "！"};
// Those of them after which the sentence may go on. Dots are such a mark if there are several.
constexpr std::array<std::string_view, 4> half_ends = {":", ";", "…", "؛"};

constexpr std::array<std::string_view, 6> double_quotes = {"\"", "“", "”", "„", "«", "»"};

bool is_one_of(const auto& characters, std::string_view character) {
  return std::find(characters.begin(), characters.end(), character) != characters.end();
}

bool is_apostrophe(std::string_view character) { return character == "'" || character == "’" || character == "‘"; }

// A quotation that was opened by one kind of mark, and the words within once that kind closes it.
class Quotation {
 public:
  // A mark outside of words; `before_letter`: a letter follows it.
  void meet(std::string_view mark, bool before_letter, std::vector<SpokenWord>& words) {
    const bool single = is_apostrophe(mark);
    if (!single && !is_one_of(double_quotes, mark)) return;
    if (!open_) {
      if (before_letter) open_ = Open{words.size(), single};
    } else if (open_->single == single && !(single && before_letter)) {
      for (auto i = open_->first; i < words.size(); ++i) words[i].quoted = true;
      open_.reset();
    }
  }

 private:
  struct Open {
    std::size_t first;
    bool single;
  };
  std::optional<Open> open_;
};

bool belongs_to_words(std::string_view character) {
  switch (kind_of(character)) {
    case CharacterKind::letter:
    case CharacterKind::digit:
      return true;
    case CharacterKind::symbol:
      return character.size() > 1;
    default:
      return false;
  }
}

}  // namespace

std::vector<SpokenWord> words_of(std::string_view text, std::size_t most, bool* cut) {
  std::vector<SpokenWord> words;
  std::size_t count = 0;
  bool inside = false, after_dot = false;
  Quotation quotation;
  if (cut) *cut = false;
  const auto folded_text = folded(text);
  std::string_view rest = folded_text;
  while (!rest.empty()) {
    const auto length = character_length(rest);
    const auto character = rest.substr(0, std::max<std::size_t>(length, 1));
    rest.remove_prefix(character.size());
    if (length == 0 || kind_of(character) == CharacterKind::invisible) continue;
    const bool joins = inside && is_apostrophe(character) && kind_of(rest) == CharacterKind::letter;
    if (joins || (belongs_to_words(character) && !is_apostrophe(character))) {
      if (!inside && most > 0 && count == most) {
        if (cut) *cut = true;
        return words;
      }
      if (!inside) words.push_back({}), ++count;
      inside = true;
      words.back().text += joins ? "'" : character;
      continue;
    }
    inside = false;
    quotation.meet(character, kind_of(rest) == CharacterKind::letter, words);
    if (is_one_of(commas, character) && (words.empty() || !words.back().comma)) {
      words.push_back({",", true});
    } else if (!words.empty() && is_one_of(ends, character)) {
      words.back().ends_after = true;
      words.back().half = is_one_of(half_ends, character) || (after_dot && character == ".");
    }
    after_dot = character == ".";
  }
  return words;
}

std::string bare_words(std::string_view text, std::string_view separator) {
  std::string out;
  for (auto& word : words_of(text)) {
    if (word.comma) continue;
    std::erase(word.text, '\'');
    if (!out.empty()) out += separator;
    out += word.text;
  }
  return out;
}

}  // namespace continua
