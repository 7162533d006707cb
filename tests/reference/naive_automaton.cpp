#include "reference/naive_automaton.h"

#include <algorithm>

namespace naive {

namespace {

const int most_epsilon_steps = 1000;

using Kind = Operation::Kind;

// The topmost symbol at the latest entry of `state` before the present one.
std::optional<Symbol> previous_entry(const Configuration& configuration, int state) {
  const auto& history = configuration.history;
  for (std::size_t i = history.size() - 1; i-- > 0;)
    if (history[i].first == state) return history[i].second;
  return std::nullopt;
}

void pop(Stack& stack) {
  if (stack.size() > 1) stack.pop_back();
}

Stack operated(const Configuration& before, const Operation& operation) {
  Stack stack = before.stack;
  const Symbol top = stack.back();
  switch (operation.kind) {
    case Kind::none:
      break;
    case Kind::push:
    case Kind::push_each:
      for (const auto& content : operation.contents) stack.push_back(filled(content, stack.back(), top));
      break;
    case Kind::pop:
      for (int i = 0; i < operation.count; ++i) pop(stack);
      break;
    case Kind::rewrite:
    case Kind::rewrite_each: {
      stack.pop_back();
      Symbol inherited = top;
      for (const auto& content : operation.contents) {
        inherited = filled(content, inherited, top);
        stack.push_back(inherited);
      }
      if (stack.empty()) stack = {bottom};
      break;
    }
    case Kind::flush:
      stack = {flushed(operation.contents.at(0), top)};
      break;
    case Kind::pop_until: {
      const auto wanted = previous_entry(before, operation.state);
      if (!wanted) stack = {flushed("..", top)};
      while (wanted && stack.size() > 1 && stack.back() != *wanted) pop(stack);
      break;
    }
  }
  return stack;
}

// The part of the history that decides pop_until, now and later.
std::vector<std::optional<Symbol>> seen_by_pop_until(const Machine& machine, const Configuration& configuration) {
  std::vector<std::optional<Symbol>> seen;
  const auto look = [&](const Operation& operation) {
    if (operation.kind != Kind::pop_until) return;
    seen.push_back(previous_entry(configuration, operation.state));
    if (configuration.state == operation.state) seen.push_back(configuration.history.back().second);
  };
  for (const auto& transition : machine.transitions) look(transition.operation);
  for (const auto& state : machine.states)
    if (state.gate) look(state.gate->operation);
  return seen;
}

struct Candidate {
  Transition transition;
  std::size_t offer;
  double weight;
};

std::optional<Candidate> chosen(const Machine& machine, const std::vector<Candidate>& candidates) {
  if (candidates.empty()) return std::nullopt;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (machine.unique && candidates[i].offer == candidates[j].offer) return std::nullopt;
  Candidate best = candidates[0];
  for (const auto& candidate : candidates)
    if (candidate.weight > best.weight) best = candidate;
  return best;
}

void add_candidates(const Machine& machine, const Configuration& now, std::optional<char> input, double confidence,
                    std::size_t offer, std::vector<Candidate>& candidates) {
  if (confidence <= 0) return;
  for (const auto& transition : applicable(machine, now, input))
    candidates.push_back({transition, offer, transition.weight * confidence});
}

bool is_rewrite(const Operation& operation) {
  return operation.kind == Kind::rewrite || operation.kind == Kind::rewrite_each;
}

// Fires ε-transitions until none applies. `after_rewrite` says whether a rewrite led here.
Step settled(const Machine& machine, Configuration now, bool after_rewrite) {
  std::vector<Configuration> passed = {now};
  if (!machine.epsilon_always && !after_rewrite) return {now, false, Trouble::none};
  while (true) {
    std::vector<Candidate> candidates;
    add_candidates(machine, now, std::nullopt, 1, 0, candidates);
    const auto best = chosen(machine, candidates);
    if (!best) break;
    if (static_cast<int>(passed.size()) > most_epsilon_steps) return {now, false, Trouble::endless};
    const auto way = way_through_gates(machine, now.stack.back(), best->transition);
    if (!way) return {now, false, Trouble::gates};
    now = *fire(machine, now, best->transition);
    after_rewrite = is_rewrite(way->operation);
    if (!machine.epsilon_always && !after_rewrite) break;
    for (const auto& earlier : passed)
      if (same(machine, earlier, now)) return {now, false, Trouble::cycle};
    passed.push_back(now);
  }
  return {now, false, Trouble::none};
}

}  // namespace

bool fits(const Symbol& symbol, const Pattern& condition) {
  for (std::size_t slot = 0; slot < symbol.size(); ++slot)
    if (condition[slot] != '.' && condition[slot] != symbol[slot]) return false;
  return true;
}

Symbol filled(const Pattern& content, const Symbol& before, const Symbol& top) {
  Symbol symbol = before;
  for (std::size_t slot = 0; slot < symbol.size(); ++slot) {
    if (content[slot] == '0' || content[slot] == '1')
      symbol[slot] = top[content[slot] - '0'];
    else if (content[slot] != '.')
      symbol[slot] = content[slot];
  }
  return symbol;
}

Symbol flushed(const Pattern& content, const Symbol& top) {
  Symbol symbol = top;
  symbol[0] = '-';
  if (content[1] == '-') symbol[1] = '-';
  return symbol;
}

bool same(const Machine& machine, const Configuration& a, const Configuration& b) {
  return a.state == b.state && a.stack == b.stack && seen_by_pop_until(machine, a) == seen_by_pop_until(machine, b);
}

Configuration start() { return {0, {bottom}, {{0, bottom}}}; }

std::vector<Transition> applicable(const Machine& machine, const Configuration& configuration,
                                   std::optional<char> input) {
  std::vector<Transition> found;
  for (const auto& transition : machine.transitions) {
    const bool takes = input ? transition.on.find(*input) != std::string::npos : transition.on.empty();
    if (takes && transition.from.count(configuration.state) && fits(configuration.stack.back(), transition.when))
      found.push_back(transition);
  }
  int highest = -1000;
  for (const auto& transition : found) highest = std::max(highest, transition.rank);
  std::vector<Transition> allowed;
  for (const auto& transition : found)
    if (transition.rank == highest) allowed.push_back(transition);
  return allowed;
}

std::optional<Way> way_through_gates(const Machine& machine, const Symbol& top, const Transition& transition) {
  Way way = {transition.to, transition.operation};
  for (std::size_t refusals = 0; refusals <= machine.states.size(); ++refusals) {
    const auto& gate = machine.states[way.to].gate;
    if (!gate || fits(top, gate->when)) return way;
    way = {gate->otherwise, gate->operation};
  }
  return std::nullopt;
}

std::optional<Configuration> fire(const Machine& machine, const Configuration& before, const Transition& transition) {
  const auto way = way_through_gates(machine, before.stack.back(), transition);
  if (!way) return std::nullopt;
  Configuration after = before;
  after.state = way->to;
  after.stack = operated(before, way->operation);
  after.history.push_back({after.state, after.stack.back()});
  return after;
}

Step begin(const Machine& machine) { return settled(machine, start(), false); }

Step step(const Machine& machine, const Configuration& before, const std::vector<Offer>& offers) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < offers.size(); ++i)
    add_candidates(machine, before, offers[i].input, offers[i].confidence, i, candidates);
  const auto best = chosen(machine, candidates);
  if (!best) return {before, true, Trouble::none};
  const auto way = way_through_gates(machine, before.stack.back(), best->transition);
  if (!way) return {before, true, Trouble::gates};
  Step step = settled(machine, *fire(machine, before, best->transition), is_rewrite(way->operation));
  step.taken = best->offer;
  return step;
}

}  // namespace naive
