#include "continua/analysis/acceptance.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/analysis/saturation.h"

namespace continua {

struct Acceptance::Work {
  std::shared_ptr<const Machine> machine;
  AcceptBy by;
  PushdownSystem system;

  bool accepting(const Saturation::Edge& edge) const {
    if (!system.ready(edge.control) || machine->states[system.state(edge.control)].passing) return false;
    if (by == AcceptBy::final_state) return machine->states[system.state(edge.control)].accepting;
    return edge.rest == Saturation::end && system.is_bare_bottom(edge.symbol);
  }
};

Acceptance::Acceptance(std::shared_ptr<const Machine> machine, AcceptBy by)
    : work_(new Work{machine, by, PushdownSystem(machine)}) {}
Acceptance::~Acceptance() = default;

Result<bool> Acceptance::accepts(const std::vector<std::string>& word) {
  auto& system = work_->system;
  if (!work_->machine->beliefs.evidence.empty() || !work_->machine->beliefs.answers.empty())
    return Error{work_->machine->name,
                 "has beliefs, so whether it takes an input hangs on more than the word; "
                 "expected a machine without"};
  Saturation reached(system);
  reached.close();
  for (const auto& symbol : word) {
    reached.read(system.letter(symbol));
    reached.close();
  }
  if (std::any_of(reached.edges().begin(), reached.edges().end(),
                  [&](const auto& edge) { return work_->accepting(edge); }))
    return true;
  if (system.overflowed())
    return Error{work_->machine->name,
                 fmt::format("makes more than {} different stack symbols or registers' values, so acceptance cannot be "
                             "decided; expected a machine whose symbols are finitely many",
                             system.most_values())};
  if (reached.exhausted())
    return Error{work_->machine->name, fmt::format("takes more than {} steps to decide this word; expected a smaller "
                                                   "machine, or a shorter word",
                                                   Saturation::most_applied)};
  return false;
}

}  // namespace continua
