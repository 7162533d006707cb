#include "continua/replay/explain/explain_lines.h"

#include <algorithm>

namespace continua {

std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Where the word that begins at `from` ends; a number and its unit, which is one letter, count as one word.
std::size_t word_end(std::string_view text, std::size_t from) {
  const auto end = std::min(text.find(' ', from), text.size());
  const bool number = end > from && is_digit(text[end - 1]) && (is_digit(text[from]) || text[from] == '(');
  const bool unit =
      end + 1 < text.size() && text[end + 1] == 's' &&
      (end + 2 == text.size() || std::string_view(" ),.;:").find(text[end + 2]) != std::string_view::npos);
  return number && unit ? std::min(text.find(' ', end + 1), text.size()) : end;
}

}  // namespace

std::string wrapped(std::string_view text, std::string_view indent, std::string_view hanging, std::size_t width) {
  std::string out;
  std::string line(indent), gap;  // the spaces before the next word, lost where a line is broken
  bool empty = true;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = word_end(text, at);
    const auto word = text.substr(at, end - at);
    if (!word.empty()) {
      if (!empty && columns_of(line) + gap.size() + columns_of(word) > width) {
        out += line + "\n";
        line = hanging;
      } else {
        line += gap;
      }
      line += word;
      gap.clear();
      empty = false;
    }
    gap += ' ';
    at = end + 1;
  }
  return out + line + "\n";
}

}  // namespace continua
