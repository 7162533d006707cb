// Reads the members of a one-line JSON object without building a tree: enough to index a log at the speed of the disk.
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace continua {

/// Walks over the values of a JSON text. Nested values are skipped, not checked.
struct LineWalk {
  std::string_view text;
  std::size_t at = 0;

  bool done() const { return at >= text.size(); }
  bool next_is(char c) const { return at < text.size() && text[at] == c; }

  void skip_space() {
    while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '\r')) ++at;
  }
  /// REQUIRES that a quote is next. False where the string does not end.
  bool skip_string() {
    for (++at; at < text.size() && text[at] != '"'; ++at)
      if (text[at] == '\\') ++at;
    return at++ < text.size();
  }
  /// False where the value does not end before the text does: it is part of an object or array.
  bool skip_value() {
    if (next_is('"')) return skip_string();
    int depth = 0;
    for (;;) {
      // Within an object or array only brackets count.
      const auto& stops = depth == 0 ? ends_values : nests;
      while (at < text.size() && !stops[static_cast<unsigned char>(text[at])]) ++at;
      if (at >= text.size()) return false;
      const char c = text[at];
      if (c == '"') {
        if (!skip_string()) return false;
      } else if (c == '{' || c == '[') {
        ++depth;
        ++at;
      } else if (depth == 0) {
        return true;
      } else {
        --depth;
        ++at;
      }
    }
  }
  /// The next value as written; empty at the end.
  std::string_view value() {
    skip_space();
    const auto from = at;
    if (done() || !skip_value()) return {};
    auto value = text.substr(from, at - from);
    while (!value.empty() && value.back() == ' ') value.remove_suffix(1);
    return value;
  }

 private:
  using Characters = std::array<bool, 256>;
  static constexpr Characters among(std::string_view characters) {
    Characters among{};
    for (const char c : characters) among[static_cast<unsigned char>(c)] = true;
    return among;
  }
  static constexpr std::string_view nesting = "\"{}[]", ending = "\"{}[],";
  static const Characters nests, ends_values;
};

inline constexpr LineWalk::Characters LineWalk::nests = among(nesting);
inline constexpr LineWalk::Characters LineWalk::ends_values = among(ending);

/// Calls `member(key, value)` for each member of the object in `line`; both are the text as written, a string with
/// its quotes. False when the line is not one whole JSON object.
template <class Member>
bool scan_members(std::string_view line, Member member) {
  LineWalk walk{line};
  walk.skip_space();
  if (!walk.next_is('{')) return false;
  ++walk.at;
  for (bool first = true;; first = false) {
    walk.skip_space();
    if (walk.next_is('}')) break;
    if (!first) {
      if (!walk.next_is(',')) return false;
      ++walk.at;
      walk.skip_space();
    }
    if (!walk.next_is('"')) return false;
    const auto key_from = walk.at;
    if (!walk.skip_string()) return false;
    const auto key = line.substr(key_from + 1, walk.at - key_from - 2);
    walk.skip_space();
    if (!walk.next_is(':')) return false;
    ++walk.at;
    const auto value = walk.value();
    if (value.empty()) return false;
    member(key, value);
  }
  ++walk.at;
  walk.skip_space();
  return walk.done();
}

/// The value of a member of the object in `text` as written, the last one of that name; empty where there is no such
/// member.
inline std::string_view member_in(std::string_view text, std::string_view name) {
  std::string_view found;
  scan_members(text, [&](std::string_view key, std::string_view value) {
    if (key == name) found = value;
  });
  return found;
}

/// Calls `element(value)` for each element of the array in `text`. False when it is not one whole JSON array.
template <class Element>
bool scan_elements(std::string_view text, Element element) {
  LineWalk walk{text};
  walk.skip_space();
  if (!walk.next_is('[')) return false;
  ++walk.at;
  for (bool first = true;; first = false) {
    walk.skip_space();
    if (walk.next_is(']')) return true;
    if (!first) {
      if (!walk.next_is(',')) return false;
      ++walk.at;
    }
    const auto value = walk.value();
    if (value.empty()) return false;
    element(value);
  }
}

/// The number written in `text`, if all of it is one.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace continua
