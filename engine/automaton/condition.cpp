#include "continua/automaton/condition.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "continua/term/term_text.h"

namespace continua {

bool holds(const Term& condition, Evaluation& evaluation) {
  evaluation.definitions_wait = true;
  const bool it_holds = evaluation.value(condition).is_true();
  evaluation.definitions_wait = false;
  return it_holds;
}

std::string why_not(const Term& condition, const Machine& machine, Evaluation& evaluation) {
  const auto [head, arguments] = condition.spine();
  if (head.kind() == Term::Kind::constant) {
    if (head.name() == "and" && arguments.size() == 2) {
      const bool left_holds = holds(arguments[0], evaluation);
      return why_not(arguments[left_holds ? 1 : 0], machine, evaluation);
    }
    const auto definition = machine.definitions.find(head.name());
    if (arguments.empty() && definition != machine.definitions.end())
      return fmt::format("{}: {}", head.name(), why_not(definition->second, machine, evaluation));
  }
  std::vector<std::string> values;
  static const std::set<std::string, std::less<>> comparisons = {"=", "!=", "<", "<=", ">", ">="};
  if (head.kind() == Term::Kind::constant && comparisons.contains(head.name()) && arguments.size() == 2)
    for (const auto& side : arguments) {
      const auto value = evaluation.value(side);
      if (!(value == side)) values.push_back(fmt::format("{} is {}", print(side), print(value)));
    }
  return fmt::format("not {}{}{}", print(condition), values.empty() ? "" : ": ", fmt::join(values, ", "));
}

}  // namespace continua
