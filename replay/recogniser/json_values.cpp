#include "continua/replay/recogniser/json_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

// The length of the value that begins at the start of the text, up to the bracket that closes it.
std::size_t value_length(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted) {
      if (c == '\\')
        ++at;
      else if (c == '"')
        quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if ((c == '}' || c == ']') && --depth <= 0) {
      return at + 1;
    }
  }
  return text.size();
}

}  // namespace

Result<std::vector<LocatedValue>> objects_in(std::string_view text, const std::string& name) {
  text = without_byte_order_mark(text);
  std::vector<LocatedValue> values;
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size();) {
    if (const auto blanks = std::min(text.find_first_not_of(" \t\r\n,", at), text.size()); blanks > at) {
      line += static_cast<std::size_t>(std::count(text.begin() + at, text.begin() + blanks, '\n'));
      at = blanks;
      continue;
    }
    const auto part = text.substr(at, value_length(text.substr(at)));
    auto value = parse_json_line(part, name, line);
    if (!value) return value.error();
    if (value->is_array())
      for (auto& one : value.value()) values.push_back({std::move(one), line});
    else
      values.push_back({std::move(value).value(), line});
    if (!values.empty() && !values.back().json.is_object())
      return lacks(name, line, "a recogniser's output as JSON objects");
    line += static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n'));
    at += part.size();
  }
  return values;
}

std::optional<double> number_of(const Json& object, const char* member) {
  const auto& value = member_of(object, member);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string trimmed_words(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first));
}

Error lacks(const std::string& name, std::size_t line, const std::string& expected) {
  return {fmt::format("{}:{}", name, line), "expected " + expected};
}

}  // namespace continua
