#include "continua/replay/coverage/coverage_phrases.h"

#include <algorithm>
#include <optional>

#include "continua/replay/coverage/coverage.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

// Values of "phrase" at any depth, in their order.
void collect_phrases(const Json& value, std::vector<std::string>& names) {
  if (!value.is_structured()) return;
  if (value.is_object())
    if (const auto name = member_of(value, "phrase"); name.is_string()) names.push_back(name.get<std::string>());
  for (const auto& inner : value) collect_phrases(inner, names);
}

// The template's own text: "Is it {wording(x)}?" has "Is it " and "?". Terms may contain braces of their own.
std::vector<std::string> literals_of(std::string_view pattern) {
  std::vector<std::string> literals(1);
  int depth = 0;
  for (const char c : pattern) {
    if (c == '{' && depth++ == 0) literals.emplace_back();
    if (depth == 0) literals.back() += c;
    if (c == '}' && depth > 0) --depth;
  }
  return literals;
}

}  // namespace

std::optional<std::size_t> fit_of(std::string_view pattern, std::string_view text) {
  const auto literals = literals_of(pattern);
  std::size_t fit = 0;
  for (const auto& literal : literals) fit += literal.size();
  if (literals.size() == 1) return text == literals.front() ? std::optional(fit) : std::nullopt;
  if (fit > text.size() || !text.starts_with(literals.front()) || !text.ends_with(literals.back())) return std::nullopt;
  text.remove_prefix(literals.front().size());
  text.remove_suffix(literals.back().size());
  for (std::size_t i = 1; i + 1 < literals.size(); ++i) {
    const auto found = text.find(literals[i]);
    if (found == std::string_view::npos) return std::nullopt;
    text.remove_prefix(found + literals[i].size());
  }
  return fit;
}

PhraseCounts::PhraseCounts(const Json& machine, const Json& phrases) {
  const auto document = member_of(machine, "document");
  transitions_ = member_of(document, "transitions");
  states_ = member_of(document, "states");
  std::vector<std::string> used;
  collect_phrases(states_, used);
  collect_phrases(transitions_, used);
  const auto say = member_of(member_of(phrases, "document"), "say");
  for (const auto& [name, cases] : say.items())
    if (std::find(used.begin(), used.end(), name) != used.end()) add_cases(cases, name);
}

void PhraseCounts::add_cases(const Json& phrases, const std::string& name) {
  if (!phrases.is_array()) return;
  for (const auto& one : phrases) {
    Case added{name, text_of(one, "when"), {}, 0};
    if (added.when.empty() && phrases.size() > 1) added.when = "otherwise";
    const auto say = member_of(one, "say");
    if (say.is_string()) added.ways = {say.get<std::string>()};
    if (say.is_array())
      for (const auto& way : say)
        if (way.is_string()) added.ways.push_back(way.get<std::string>());
    cases_.push_back(std::move(added));
  }
}

void PhraseCounts::said(const std::string& text, const std::string& transition, const std::string& state) {
  std::vector<std::string> phrases;
  if (transitions_.is_array())
    for (const auto& one : transitions_)
      if (text_of(one, "id") == transition) collect_phrases(one, phrases);
  collect_phrases(member_of(states_, state.c_str()), phrases);
  std::size_t best = 0;
  std::vector<Case*> fitting;
  for (auto& one : cases_) {
    if (std::find(phrases.begin(), phrases.end(), one.phrase) == phrases.end()) continue;
    std::optional<std::size_t> fit;
    for (const auto& way : one.ways)
      if (const auto of_way = fit_of(way, text)) fit = std::max(fit.value_or(0), *of_way);
    if (!fit || (!fitting.empty() && *fit < best)) continue;
    if (*fit > best) fitting.clear();
    best = *fit;
    fitting.push_back(&one);
  }
  for (auto* one : fitting) ++one->count;
}

CoverageKind PhraseCounts::reached() const {
  CoverageKind kind{"phrases"};
  for (const auto& one : cases_) kind.items.push_back({one.phrase, "", one.when, one.count});
  return kind;
}

}  // namespace continua
