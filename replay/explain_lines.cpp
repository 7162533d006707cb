#include "replay/explain_lines.h"

#include <algorithm>

namespace continua {

std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string wrapped(std::string_view text, std::string_view indent, std::string_view hanging, std::size_t width) {
  std::string out;
  std::string line(indent);
  bool empty = true;
  for (std::size_t at = 0; at <= text.size();) {
    const auto end = std::min(text.find(' ', at), text.size());
    const auto word = text.substr(at, end - at);
    if (!empty && columns_of(line) + 1 + columns_of(word) > width) {
      out += line + "\n";
      line = hanging;
      empty = true;
    }
    if (!empty) line += ' ';
    line += word;
    empty = empty && word.empty();
    at = end + 1;
  }
  return out + line + "\n";
}

}  // namespace continua
