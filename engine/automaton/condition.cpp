#include "continua/automaton/condition.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "continua/term/term_text.h"

namespace continua {

std::string why_not(const Term& condition, const Machine& machine, Evaluation& evaluation) {
  const auto [head, arguments] = condition.spine();
  if (head.kind() == Term::Kind::constant) {
    if (head.name() == "and" && arguments.size() == 2) {
      const bool left_holds = evaluation.value(arguments[0]).is_true();
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
