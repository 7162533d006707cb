#include "continua/replay/explain/explain_stack.h"

#include <algorithm>

#include "continua/replay/explain/explain_origin.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_views.h"

namespace continua {
namespace {

// The record before the change: of a step the one before it; else the input; else the run's first.
std::size_t begin_of_change(ExplainScope& scope) {
  const auto n = scope.n();
  const auto& kind = scope.run().kind(n);
  if (log::is<log::Symbol>(kind) || log::is<log::Transition>(kind) || log::is<log::Correction>(kind) ||
      log::is<log::Rewrite>(kind)) {
    auto begin = n;
    while (begin > 1 && (begin == n || log::is<log::Symbol>(scope.run().kind(begin)))) --begin;
    return begin;
  }
  return scope.input_of(n).value_or(0);
}

const Json& top_slots(ExplainScope& scope, std::size_t mark) {
  static const Json none = Json::object();
  const auto* symbol = scope.run().symbol(scope.run().stack_marks()[mark].top);
  return symbol ? member_of(scope.record(symbol->n), "slots") : none;
}

// The expression of a record's operation for a slot.
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

// The record that gave the slot of the symbol that record `made` has written its value: the operation that made the
// symbol, or, where that only took the value along, the one that had set it on the top before, after `begin`.
std::optional<std::size_t> setter_of(ExplainScope& scope, const std::string& slot, const Json& value, std::size_t made,
                                     std::size_t begin) {
  const auto& marks = scope.run().stack_marks();
  auto mark = static_cast<std::size_t>(std::upper_bound(marks.begin(), marks.end(), made,
                                                        [](std::size_t n, const StackMark& one) { return n < one.n; }) -
                                       marks.begin());
  if (mark == marks.size()) return std::nullopt;
  for (;; --mark) {
    if (sets(scope, marks[mark].n, slot.c_str())) return marks[mark].n;
    const bool had =
        mark > 0 && marks[mark - 1].n > begin && member_of(top_slots(scope, mark - 1), slot.c_str()) == value;
    if (!had) return marks[mark].n;
  }
}

std::optional<std::size_t> application_of(ExplainScope& scope, const std::string& term, std::size_t before) {
  for (const auto n : scope.latest(log::Application::kind.name))
    if (n < before && text_of(scope.record(n), "result") == term) return n;
  return std::nullopt;
}

// Where the value is from, unless it is from the change itself, of which `by` and `expression` say more.
Json origin_before(ExplainScope& scope, const std::string& value, std::size_t at, std::size_t begin) {
  auto origin = origin_of(scope, value, at);
  const auto kind = text_of(origin, "kind");
  const bool within = origin["n"].get<std::size_t>() > begin;
  return kind == "machine" || (within && (kind == "slot" || kind == "memory")) ? Json() : origin;
}

}  // namespace

Result<Json> explained_stack(ExplainScope& scope) {
  const auto begin = begin_of_change(scope);
  auto change = run_stack_since(scope.run(), begin, scope.n());
  if (!change) return change.error();
  Json stack{{"before", (*change)["depth_before"]}, {"after", (*change)["depth"]}, {"since", begin}};
  for (auto& symbol : (*change)["symbols"]) {
    if (!symbol.contains("slots_changed")) continue;
    for (auto& [slot, changed] : symbol["slots_changed"].items()) {
      const auto by = setter_of(scope, slot, changed["now"], symbol["made"].get<std::size_t>(), begin);
      const auto value = text_of(changed, "now");
      const auto at = by.value_or(scope.n());
      const auto made = application_of(scope, value, at + 1);
      changed["by"] = by ? Json(*by) : Json();
      changed["expression"] = by ? expression_for(scope, *by, slot.c_str()) : Json();
      changed["application"] = made ? Json(*made) : Json();
      changed["origin"] = value.empty() ? Json() : origin_before(scope, value, at, begin);
    }
  }
  stack["symbols"] = std::move((*change)["symbols"]);
  stack["removed"] = std::move((*change)["removed"]);
  return stack;
}

}  // namespace continua
