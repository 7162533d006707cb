#include "reference/naive_exploration.h"

#include <algorithm>

namespace naive {

namespace {

struct Reached {
  Configuration configuration;
  bool tries_epsilon = true;
};

bool tries_epsilon(const Machine& machine, const Configuration& before, const Transition& transition) {
  const auto way = way_through_gates(machine, before.stack.back(), transition);
  return machine.epsilon_always || way->operation.kind == Operation::Kind::rewrite ||
         way->operation.kind == Operation::Kind::rewrite_each;
}

// The configurations that `input` leads to from one.
void add_next(const Machine& machine, const Configuration& before, std::optional<char> input,
              std::vector<Reached>& reached) {
  for (const auto& transition : applicable(machine, before, input)) {
    const auto after = fire(machine, before, transition);
    if (!after) continue;
    const Reached next = {*after, tries_epsilon(machine, before, transition)};
    const bool known = std::any_of(reached.begin(), reached.end(), [&](const Reached& one) {
      return one.tries_epsilon == next.tries_epsilon && same(machine, one.configuration, next.configuration);
    });
    if (!known) reached.push_back(next);
  }
}

std::optional<Configurations> with_epsilon(const Machine& machine, std::vector<Reached> reached, std::size_t most) {
  for (std::size_t i = 0; i < reached.size() && reached.size() <= most; ++i) {
    const Reached now = reached[i];
    if (now.tries_epsilon) add_next(machine, now.configuration, std::nullopt, reached);
  }
  if (reached.size() > most) return std::nullopt;
  Configurations all;
  for (const auto& one : reached)
    if (std::none_of(all.begin(), all.end(),
                     [&](const auto& known) { return same(machine, known, one.configuration); }))
      all.push_back(one.configuration);
  return all;
}

}  // namespace

std::optional<Configurations> explored(const Machine& machine, std::size_t most) {
  return with_epsilon(machine, {{start(), machine.epsilon_always}}, most);
}

std::optional<Configurations> explored(const Machine& machine, const Configurations& before,
                                       const std::vector<Offer>& offers, std::size_t most) {
  std::vector<Reached> reached;
  for (const auto& configuration : before)
    for (const auto& [input, confidence] : offers)
      if (confidence > 0) add_next(machine, configuration, input, reached);
  return with_epsilon(machine, reached, most);
}

bool accepts(const Machine& machine, const Configuration& configuration, Acceptance by) {
  return by == Acceptance::final_state ? machine.states[configuration.state].accepting
                                       : configuration.stack == Stack{bottom};
}

}  // namespace naive
