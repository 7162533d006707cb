#include "continua/replay/recogniser/json_reader.h"

#include <fmt/format.h>

#include "continua/core/trimmed.h"
#include "continua/replay/log/run_brief.h"

namespace continua {

void JsonReader::read(const OutputPart& part, Recognised& gain) {
  const auto value = parse_json_line(part.text, name(), part.line);
  if (!value) {
    gain.problems.push_back(value.error());
    return;
  }
  const auto read_one = [&](const Json& one) {
    if (one.is_object())
      read_object(one, part.line, gain);
    else
      gain.problems.push_back(lacks(name(), part.line, "a recogniser's output as JSON objects"));
  };
  if (!value->is_array()) return read_one(*value);
  for (const auto& one : *value) read_one(one);
}

std::optional<double> number_of(const Json& object, const char* member) {
  const auto& value = member_of(object, member);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

const Json& either_member(const Json& object, const char* name, const char* other) {
  const auto& value = member_of(object, name);
  return value.is_null() ? member_of(object, other) : value;
}

std::string trimmed_words(std::string_view text) { return std::string(trimmed(text)); }

Error lacks(const std::string& name, std::size_t line, const std::string& expected) {
  return {fmt::format("{}:{}", name, line), "expected " + expected};
}

}  // namespace continua
