#include "continua/voxml/catalogue_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "continua/core/characters.h"
#include "continua/core/located_json.h"

namespace continua {
namespace {

void add(std::string& text, std::uint32_t point) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((point >> shift) & 0x3F)); };
  if (point < 0x80) {
    text += static_cast<char>(point);
  } else if (point < 0x800) {
    text += static_cast<char>(0xC0 | (point >> 6));
    tail(0);
  } else if (point < 0x10000) {
    text += static_cast<char>(0xE0 | (point >> 12));
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xF0 | (point >> 18));
    tail(12), tail(6), tail(0);
  }
}

std::string from_utf16(std::string_view text, bool little) {
  std::string utf8;
  std::uint32_t first_half = 0;
  for (std::size_t at = 0; at + 2 <= text.size(); at += 2) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + i]));
    };
    const std::uint32_t unit = little ? byte(1) << 8 | byte(0) : byte(0) << 8 | byte(1);
    if (first_half != 0 && (unit & 0xFC00) == 0xDC00) {
      add(utf8, 0x10000 + ((first_half & 0x3FF) << 10) + (unit & 0x3FF));
      first_half = 0;
      continue;
    }
    if (first_half != 0) add(utf8, first_half);  // half a surrogate pair: not a character, so refused as invalid UTF-8
    first_half = (unit & 0xFC00) == 0xD800 ? unit : 0;
    if (first_half == 0) add(utf8, unit);
  }
  if (first_half != 0) add(utf8, first_half);
  return utf8;
}

std::string lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

// The encoding in the XML declaration, in lower case; empty without one.
std::string declared(std::string_view text) {
  const auto begin = text.find("<?xml");
  if (begin == text.npos) return "";
  const auto declaration = text.substr(begin, text.find("?>", begin) - begin);
  const auto name = declaration.find("encoding");
  if (name == declaration.npos) return "";
  const auto open = declaration.find_first_of("'\"", name);
  if (open == declaration.npos) return "";
  const auto close = declaration.find(declaration[open], open + 1);
  return close == declaration.npos ? "" : lower(declaration.substr(open + 1, close - open - 1));
}

}  // namespace

Result<std::string> utf8_of_xml(std::string_view text, const std::string& path) {
  constexpr std::array<std::string_view, 5> one_byte = {"iso-8859-1", "iso8859-1", "latin1", "latin-1", "windows-1252"};
  std::string encoding = "UTF-16", utf8;
  if (text.starts_with("\xFF\xFE") || text.starts_with(std::string_view("<\0", 2))) {
    utf8 = from_utf16(text, true);
  } else if (text.starts_with("\xFE\xFF") || text.starts_with(std::string_view("\0<", 2))) {
    utf8 = from_utf16(text, false);
  } else if (encoding = declared(text); std::find(one_byte.begin(), one_byte.end(), encoding) != one_byte.end()) {
    for (const char c : text) add(utf8, static_cast<unsigned char>(c));
  } else {
    utf8 = text;
  }
  utf8 = without_byte_order_mark(utf8);
  std::size_t line = 1;
  for (std::size_t at = 0, length = 0; at < utf8.size(); at += length) {
    length = character_length(std::string_view(utf8).substr(at));
    if (length == 0 || utf8[at] == '\0')
      return Error{fmt::format("{}:{}", path, line),
                   fmt::format("found the byte {:#04x}, expected XML in {}",
                               static_cast<unsigned>(static_cast<unsigned char>(utf8[at])),
                               encoding.empty() ? "UTF-8" : encoding)};
    if (utf8[at] == '\n') ++line;
  }
  return utf8;
}

}  // namespace continua
