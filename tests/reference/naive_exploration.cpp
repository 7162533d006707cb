#include "reference/naive_exploration.h"

#include <algorithm>

namespace naive {

namespace {

void add(const Machine& machine, Configurations& to, const Configuration& configuration) {
  for (const auto& known : to)
    if (same(machine, known, configuration)) return;
  to.push_back(configuration);
}

}  // namespace

std::optional<Configurations> with_epsilon(const Machine& machine, Configurations configurations, std::size_t most) {
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    const Configuration now = configurations[i];
    for (const auto& transition : applicable(machine, now, std::nullopt))
      if (const auto after = fire(machine, now, transition)) add(machine, configurations, *after);
    if (configurations.size() > most) return std::nullopt;
  }
  return configurations;
}

std::optional<Configurations> explored(const Machine& machine, const Configurations& before, char input,
                                       std::size_t most) {
  Configurations after;
  for (const auto& configuration : before)
    for (const auto& transition : applicable(machine, configuration, input))
      if (const auto next = fire(machine, configuration, transition)) add(machine, after, *next);
  return with_epsilon(machine, after, most);
}

bool accepts(const Machine& machine, const Configuration& configuration, Acceptance by) {
  return by == Acceptance::final_state ? machine.states[configuration.state].accepting
                                       : configuration.stack == Stack{bottom(machine)};
}

}  // namespace naive
