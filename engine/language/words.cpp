#include "language/words.h"

#include <algorithm>
#include <cctype>

#include "core/characters.h"

namespace continua {

std::vector<SpokenWord> words_of(std::string_view text, std::size_t most, bool* cut) {
  std::vector<SpokenWord> words;
  std::size_t count = 0;
  bool inside = false;
  if (cut) *cut = false;
  const auto add = [&](std::string_view part) {
    if (!inside) words.push_back({}), ++count;
    inside = true;
    words.back().text += part;
  };
  for (std::size_t at = 0; at < text.size();) {
    const auto length = character_length(text.substr(at));
    auto character = text.substr(at, std::max<std::size_t>(length, 1));
    at += character.size();
    if (length == 0) continue;
    if (character == "’" || character == "‘") character = "'";
    const char c = character.front();
    const bool letter =
        (length > 1 && c != '\'') || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool joins = c == '\'' && inside && at < text.size() && std::isalpha(static_cast<unsigned char>(text[at]));
    if (letter || joins) {
      if (!inside && most > 0 && count == most) {
        if (cut) *cut = true;
        return words;
      }
      add(c >= 'A' && c <= 'Z' ? std::string(1, static_cast<char>(c - 'A' + 'a')) : std::string(character));
      continue;
    }
    inside = false;
    if (c == ',' && (words.empty() || !words.back().comma))
      words.push_back({",", true, false});
    else if (!words.empty() && (c == '.' || c == '?' || c == '!' || c == ';' || c == ':'))
      words.back().ends_after = true;
  }
  return words;
}

}  // namespace continua
