#include "continua/analysis/machine_analysis.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "continua/analysis/condition_overlap.h"
#include "continua/analysis/head_analysis.h"
#include "continua/analysis/machine_reads.h"

namespace continua {
namespace {

// The states that a transition may lead to, with the `else` states of gates.
std::vector<StateIndex> targets(const Machine& machine, const Transition& transition) {
  std::vector<StateIndex> found{transition.to};
  while (const auto& gate = machine.states[found.back()].gate) {
    if (std::find(found.begin(), found.end(), gate->otherwise) != found.end()) break;
    found.push_back(gate->otherwise);
  }
  return found;
}

// A symbol in both sets.
std::optional<std::string> common_symbol(const SymbolSet& a, const SymbolSet& b) {
  for (const auto& name : a.names)
    if (b.contains(name)) return name;
  for (const auto& name : b.names)
    if (a.contains(name)) return name;
  for (const auto& one : a.prefixes)
    for (const auto& other : b.prefixes)
      if (one.starts_with(other) || other.starts_with(one)) return std::max(one, other) + "…";
  return std::nullopt;
}

void judge_conflict(const Machine& machine, StateIndex state, std::size_t first, std::size_t second,
                    MachineAnalysis& analysis) {
  const auto& a = machine.transitions[first];
  const auto& b = machine.transitions[second];
  if (a.on.has_value() == b.on.has_value() && a.rank != b.rank) return;
  std::optional<std::string> input;
  if (a.on && b.on) {
    input = common_symbol(*a.on, *b.on);
    if (!input) return;
  } else if (a.on || b.on) {
    if (!machine.epsilon_always) return;
    const auto& on = a.on ? *a.on : *b.on;
    input = on.names.empty() ? *on.prefixes.begin() + "…" : *on.names.begin();
  }
  if (const auto both = overlap(a.when, b.when, machine))
    analysis.conflicts.push_back({state, first, second, input, *both, std::nullopt});
}

// Judges the machine by its graph and the text of its conditions.
void judge(const Machine& machine, MachineAnalysis& analysis) {
  std::vector<bool> reached(machine.states.size(), false), fires(machine.transitions.size(), false);
  std::vector<std::vector<std::size_t>> leaving(machine.states.size());
  for (std::size_t i = 0; i < machine.transitions.size(); ++i)
    if (overlap(machine.transitions[i].when, std::nullopt, machine))
      for (const auto from : machine.transitions[i].from) leaving[from].push_back(i);
  std::vector<StateIndex> open{machine.start};
  reached[machine.start] = true;
  while (!open.empty()) {
    const auto state = open.back();
    open.pop_back();
    for (const auto i : leaving[state]) {
      fires[i] = true;
      for (const auto to : targets(machine, machine.transitions[i]))
        if (!reached[to]) reached[to] = true, open.push_back(to);
    }
  }
  for (StateIndex state = 0; state < machine.states.size(); ++state) {
    if (!reached[state]) {
      analysis.unreachable.push_back(state);
      continue;
    }
    for (std::size_t b = 0; b < leaving[state].size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        judge_conflict(machine, state, leaving[state][a], leaving[state][b], analysis);
  }
  for (std::size_t i = 0; i < fires.size(); ++i)
    if (!fires[i]) analysis.never_fires.push_back(i);
}

void find_dead_ends(const Machine& machine, MachineAnalysis& analysis) {
  const auto contains = [](const auto& list, std::size_t one) {
    return std::find(list.begin(), list.end(), one) != list.end();
  };
  const bool accepts =
      std::any_of(machine.states.begin(), machine.states.end(), [](const State& s) { return s.accepting; });
  std::vector<bool> alive(machine.states.size(), false);
  if (accepts)
    for (StateIndex state = 0; state < alive.size(); ++state) alive[state] = machine.states[state].accepting;
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < machine.transitions.size(); ++i) {
      if (contains(analysis.never_fires, i)) continue;
      const auto& transition = machine.transitions[i];
      for (const auto from : transition.from) {
        if (alive[from]) continue;
        for (const auto to : targets(machine, transition))
          if (accepts ? alive[to] : to != from) alive[from] = grows = true;
      }
    }
  }
  for (StateIndex state = 0; state < alive.size(); ++state)
    if (!alive[state] && !contains(analysis.unreachable, state)) analysis.dead_ends.push_back(state);
}

}  // namespace

std::string MachineAnalysis::class_name() const {
  return std::string(deterministic ? "D" : "N") + (uses_stack ? "PDA" : "FA");
}

MachineAnalysis analyse(const std::shared_ptr<const Machine>& machine) {
  MachineAnalysis analysis;
  visit_operations(*machine, [&](const Operation& operation) {
    analysis.uses_stack |= operation.kind != Operation::Kind::none && !operation.keeps_stack;
  });
  analysis.weighted = std::any_of(machine->transitions.begin(), machine->transitions.end(),
                                  [](const Transition& transition) { return transition.weight != 1; });
  if (const auto outside = reads_from_outside(*machine)) {
    analysis.undecided = fmt::format("it reads {}", *outside);
  } else if (MachineAnalysis exact = analysis; analyse_heads(machine, exact)) {
    analysis = std::move(exact);
    analysis.decided = true;
  } else {
    analysis.undecided = "its stack symbols or registers take endlessly many values, or too many to consider";
  }
  if (!analysis.decided) judge(*machine, analysis);
  find_dead_ends(*machine, analysis);
  std::sort(analysis.conflicts.begin(), analysis.conflicts.end(), [](const Conflict& a, const Conflict& b) {
    return std::tie(a.state, a.first, a.second) < std::tie(b.state, b.first, b.second);
  });
  analysis.deterministic = analysis.conflicts.empty() && !analysis.weighted;
  return analysis;
}

}  // namespace continua
