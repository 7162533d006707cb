// Reads the members of a one-line JSON object without building a tree: enough to index a log at the speed of the disk.
#pragma once

#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace continua {

/// Calls `member(key, value)` for each member of the object in `line`; both are the text as written, a string with
/// its quotes. False when the line is not one whole JSON object. Nested values are skipped, not checked.
template <class Member>
bool scan_members(std::string_view line, Member member) {
  std::size_t at = 0;
  const auto skip_space = [&] {
    while (at < line.size() && (line[at] == ' ' || line[at] == '\t' || line[at] == '\r')) ++at;
  };
  const auto skip_string = [&] {
    for (++at; at < line.size() && line[at] != '"'; ++at)
      if (line[at] == '\\') ++at;
    return at++ < line.size();
  };
  const auto skip_value = [&] {
    if (line[at] == '"') return skip_string();
    int depth = 0;
    for (; at < line.size(); ++at) {
      const char c = line[at];
      if (c == '"') {
        if (!skip_string()) return false;
        --at;
      } else if (c == '{' || c == '[') {
        ++depth;
      } else if (c == '}' || c == ']') {
        if (depth == 0) return true;
        --depth;
      } else if (c == ',' && depth == 0) {
        return true;
      }
    }
    return false;
  };
  skip_space();
  if (at >= line.size() || line[at++] != '{') return false;
  for (bool first = true;; first = false) {
    skip_space();
    if (at >= line.size()) return false;
    if (line[at] == '}') break;
    if (!first) {
      if (line[at++] != ',') return false;
      skip_space();
    }
    if (at >= line.size() || line[at] != '"') return false;
    const auto key_from = at;
    if (!skip_string()) return false;
    const auto key = line.substr(key_from + 1, at - key_from - 2);
    skip_space();
    if (at >= line.size() || line[at++] != ':') return false;
    skip_space();
    if (at >= line.size()) return false;
    const auto value_from = at;
    if (!skip_value()) return false;
    auto value = line.substr(value_from, at - value_from);
    while (!value.empty() && value.back() == ' ') value.remove_suffix(1);
    if (value.empty()) return false;
    member(key, value);
  }
  ++at;
  skip_space();
  return at == line.size();
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
