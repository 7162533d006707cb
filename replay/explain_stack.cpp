#include "replay/explain_stack.h"

#include <algorithm>

#include "replay/explain_origin.h"
#include "replay/run_brief.h"
#include "replay/run_views.h"

namespace continua {
namespace {

// The record before which the change begins: of a step the one before it; else the input.
std::optional<std::size_t> begin_of_change(ExplainScope& scope) {
  const auto n = scope.n();
  const auto& kind = scope.run().kind(n);
  if (kind == "transition" || kind == "rewrite") return n == 0 ? std::nullopt : std::optional(n - 1);
  if (const auto input = scope.input_of(n)) return *input;
  return std::nullopt;
}

const Json& top_slots(ExplainScope& scope, std::size_t mark) {
  static const Json none = Json::object();
  const auto& symbols = scope.run().symbols();
  const auto symbol = symbols.find(scope.run().stack_marks()[mark].top);
  return symbol == symbols.end() ? none : member_of(scope.record(symbol->second.n), "slots");
}

// What the operation of a record has for a slot.
const Json& expression_for(ExplainScope& scope, std::size_t n, const char* slot) {
  const auto& operation = member_of(scope.record(n), "operation");
  static const Json nothing;
  return operation.is_object() && !operation.empty() ? member_of(operation.begin().value(), slot) : nothing;
}

bool sets(ExplainScope& scope, std::size_t n, const char* slot) {
  const auto& operation = member_of(scope.record(n), "operation");
  return operation.is_object() && !operation.empty() && operation.begin().value().is_object() &&
         operation.begin().value().contains(slot);
}

// The latest record from mark `last` back to `first` after which the top had this value in the slot, and not before.
std::optional<std::size_t> setter_of(ExplainScope& scope, const std::string& slot, const Json& value,
                                     std::size_t first, std::size_t last) {
  const auto& marks = scope.run().stack_marks();
  for (auto mark = last + 1; mark-- > first;) {
    const bool had = mark > 0 && member_of(top_slots(scope, mark - 1), slot.c_str()) == value;
    const bool has = member_of(top_slots(scope, mark), slot.c_str()) == value;
    if (has && (!had || sets(scope, marks[mark].n, slot.c_str()))) return marks[mark].n;
  }
  return std::nullopt;
}

std::optional<std::size_t> application_of(ExplainScope& scope, const std::string& term, std::size_t before) {
  for (const auto n : scope.latest("application"))
    if (n < before && text_of(scope.record(n), "result") == term) return n;
  return std::nullopt;
}

}  // namespace

Result<Json> explained_stack(ExplainScope& scope) {
  const auto& run = scope.run();
  const auto begin = begin_of_change(scope);
  auto change = run_stack_since(run, begin, scope.n());
  if (!change) return change.error();
  const auto before = begin ? run.mark_at(*begin) : std::nullopt, last = run.mark_at(scope.n());
  Json stack{{"before", before ? run.stack_ids(run.stack_marks()[*before].top).size() : std::size_t{0}},
             {"after", (*change)["depth"]},
             {"since", begin ? Json(*begin) : Json()}};
  for (auto& symbol : (*change)["symbols"]) {
    if (!symbol.contains("slots_changed")) continue;
    for (auto& [slot, changed] : symbol["slots_changed"].items()) {
      const auto by = last ? setter_of(scope, slot, changed["now"], before ? *before + 1 : 0, *last) : std::nullopt;
      const auto value = text_of(changed, "now");
      const auto at = by.value_or(scope.n());
      const auto made = application_of(scope, value, at + 1);
      changed["by"] = by ? Json(*by) : Json();
      changed["expression"] = by ? expression_for(scope, *by, slot.c_str()) : Json();
      changed["application"] = made ? Json(*made) : Json();
      if (!changed["now"].is_null()) changed["origin"] = origin_of(scope, value, at);
    }
  }
  stack["symbols"] = std::move((*change)["symbols"]);
  stack["removed"] = std::move((*change)["removed"]);
  return stack;
}

}  // namespace continua
