#include "continua/replay/log/expectation_words.h"

#include <fmt/format.h>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

bool is_met(const Json& expect) {
  return member_of(expect, std::string(log::name_of(&log::Expect::met)).c_str()) == true;
}

}  // namespace

std::vector<ToldField> told_fields(const RunWords& words, const Json& expect) {
  const auto member = [&](auto part) -> const Json& {
    return member_of(expect, std::string(log::name_of(part)).c_str());
  };
  const auto &expected = member(&log::Expect::expected), &found = member(&log::Expect::found);
  std::vector<ToldField> fields;
  if (!expected.is_object()) return fields;
  for (const auto& [name, value] : expected.items()) {
    const auto& seen = member_of(found, name.c_str());
    const bool met = is_met(expect) || seen == value;
    fields.push_back({words.expectation(name), words.expected(name, value), words.expected(name, met ? value : seen),
                      compact({{name, value}}), compact({{name, met ? value : seen}}), met});
  }
  return fields;
}

std::string wanted_text(const RunWords& words, const Json& expected) {
  std::string text;
  for (const auto& [name, value] : expected.items())
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", words.expectation(name), words.expected(name, value));
  return text;
}

std::string differences_text(const RunWords& words, const Json& expect) {
  std::string text;
  for (const auto& field : told_fields(words, expect)) {
    if (field.met && !is_met(expect)) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", field.name, field.expected);
    if (!field.met) text += ", found " + field.found;
  }
  return text;
}

std::string expectation_text(const RunWords& words, const Json& expect) {
  return (is_met(expect) ? "met: " : "not met: ") + differences_text(words, expect);
}

}  // namespace continua
