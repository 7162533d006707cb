#include "continua/core/markup.h"

#include "continua/core/characters.h"

namespace continua {
namespace {

constexpr std::string_view replacement = "\uFFFD";

// A character of one byte.
std::string in_markup(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&apos;";
    case '\n':
      return "\n";
    default:
      return c < ' ' ? std::string{'\xE2', '\x90', static_cast<char>(0x80 + c)} : std::string(1, c);
  }
}

}  // namespace

std::string in_markup(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto length = character_length(text);
    const auto character = text.substr(0, length);
    if (length == 0 || character == "\uFFFE" || character == "\uFFFF")
      out += replacement;
    else if (length == 1)
      out += in_markup(text.front());
    else
      out += character;
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

}  // namespace continua
