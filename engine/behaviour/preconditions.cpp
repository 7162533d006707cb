#include "continua/behaviour/preconditions.h"

#include <algorithm>

#include "continua/term/term_text.h"

namespace continua {
namespace {

// In an affordance every part is the object, and every unbound name is the agent.
void bind_names(const Expression& expression, const Term& object, Bindings& bindings) {
  if (expression.kind == Expression::Kind::component) bindings.emplace("[" + expression.name + "]", object);
  if (expression.kind == Expression::Kind::name) bindings.emplace(expression.name, agent_term());
  for (const auto& each : expression.arguments) bind_names(each, object, bindings);
}

Bindings bindings_of(const Affordance& affordance, const Term& object, Bindings bindings = {}) {
  bind_names(affordance.event, object, bindings);
  for (const auto& each : affordance.conditions) bind_names(each, object, bindings);
  for (const auto& each : affordance.results) bind_names(each, object, bindings);
  return bindings;
}

// Values of the names in the affordance's event if `program` is such an event. The agent may be left out.
std::optional<Bindings> matched(const Expression& event, const Term& program, const Term& object) {
  const auto [head, arguments] = program.spine();
  if (head.kind() != Term::Kind::constant || head.name() != event.name) return std::nullopt;
  const auto part = std::find_if(event.arguments.begin(), event.arguments.end(),
                                 [](const auto& one) { return one.kind == Expression::Kind::component; });
  const auto place = std::find(arguments.begin(), arguments.end(), object);
  if (part == event.arguments.end() || place == arguments.end()) return std::nullopt;
  const auto agents = (part - event.arguments.begin()) - (place - arguments.begin());
  if (agents != 0 && agents != 1) return std::nullopt;
  Bindings bindings;
  for (std::size_t i = 0; i < arguments.size() && i + agents < event.arguments.size(); ++i)
    if (const auto& each = event.arguments[i + agents]; each.kind == Expression::Kind::name)
      bindings.emplace(each.name, arguments[i]);
  return bindings;
}

}  // namespace

std::optional<Outstanding> outstanding(const Term& program, const Term& object, const Voxeme& voxeme,
                                       const Circumstances& circumstances) {
  std::optional<Outstanding> first;
  for (const auto& affordance : voxeme.affordances) {
    const auto names = matched(affordance.event, program, object);
    if (!names) continue;
    const auto bindings = bindings_of(affordance, object, *names);
    const auto lacking =
        std::find_if(affordance.conditions.begin(), affordance.conditions.end(),
                     [&](const auto& condition) { return circumstances.hold(condition, bindings) == false; });
    if (lacking == affordance.conditions.end()) return std::nullopt;
    if (first) continue;
    const Term wanted = circumstances.value(*lacking, bindings);
    first = Outstanding{print(wanted), {}};
    for (const auto& other : voxeme.affordances) {
      const auto others = bindings_of(other, object);
      const bool brings = std::any_of(other.results.begin(), other.results.end(), [&](const auto& result) {
        return circumstances.value(result, others) == wanted;
      });
      if (brings) first->programs.push_back(circumstances.value(other.event, others));
    }
  }
  return first;
}

}  // namespace continua
