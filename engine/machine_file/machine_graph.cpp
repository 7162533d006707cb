// States and transitions of a machine file.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "machine_file/machine_reader.h"

namespace continua {
namespace {

// One transition from each of its states, by each of its symbols.
constexpr std::size_t most_arcs = 1'000'000;

}  // namespace

StateIndex MachineReader::add_state(const std::string& name) {
  const auto [known, fresh] = state_index_.emplace(name, machine_.states.size());
  if (fresh) machine_.states.push_back({name, false, std::nullopt, {}});
  return known->second;
}

// States are known before transitions are read: those of `states`, or, without it, those transitions lead from or to.
void MachineReader::read_state_names(const Item& root) {
  const auto add = [&](const Json& name) {
    if (name.is_string() && name != "*" && name != "") add_state(name.get<std::string>());
  };
  const auto states = member(root, "states");
  if (states.json && states.json->is_object() && !states.json->empty()) {
    for (const auto& [name, value] : states.json->items()) add(Json(name));
    return;
  }
  const auto transitions = member(root, "transitions");
  if (transitions.json && transitions.json->is_array()) {
    for (const auto& transition : *transitions.json) {
      if (!transition.is_object()) continue;
      if (const auto from = transition.find("from"); from != transition.end()) {
        if (from->is_array())
          for (const auto& name : *from) add(name);
        else
          add(*from);
      }
      if (const auto to = transition.find("to"); to != transition.end()) add(*to);
    }
  }
}

// Of a state that there is not, the first; there is always one.
StateIndex MachineReader::state_named(const Item& item) {
  const auto name = name_of(item, "a state");
  if (const auto found = state_index_.find(name); found != state_index_.end()) {
    mentions_[name].push_back(item);
    return found->second;
  }
  if (!name.empty()) {
    std::vector<std::string> known;
    for (const auto& state : machine_.states) known.push_back(state.name);
    problem(item, fmt::format("unknown state {}{}", in_quotes(name), nearest(name, known)));
  }
  if (machine_.states.empty()) machine_.states.emplace_back();
  return 0;
}

void MachineReader::read_states(const Item& states) {
  if (!expect_object(states, "states")) return;
  for (const auto& [name, value] : states.json->items()) {
    const auto item = member(states, name);
    const auto known = state_index_.find(name);
    if (known == state_index_.end()) {
      problem_at_key(item, fmt::format("found {}, expected the name of a state", in_quotes(name)));
      continue;
    }
    mentions_[name].push_back(item);
    if (!expect_object(item, "a state")) continue;
    read_gate(member(item, "gate"), known->second);
    machine_.states[known->second].enter = read_effects(member(item, "enter"));
    machine_.states[known->second].passing = truth_of(member(item, "passing"), false);
  }
}

void MachineReader::read_gate(const Item& gate, StateIndex state) {
  if (!expect_object(gate, "a gate")) return;
  const auto when = parse(required(gate, "when", "the condition on which the state is entered"), Type::truth());
  const auto otherwise = required(gate, "else", "the state to enter where the condition does not hold");
  const auto leads_to = otherwise.json ? state_named(otherwise) : state;
  if (otherwise.json && *otherwise.json == machine_.states[state].name)
    problem(otherwise, "the gate of a state leads to that state itself; expected another one");
  auto operation = read_operation(gate);
  if (when) machine_.states[state].gate = Gate{*when, leads_to, std::move(operation)};
}

void MachineReader::read_transitions(const Item& transitions) {
  if (!expect_array(transitions, "the transitions")) return;
  std::set<std::string> ids;
  std::size_t arcs = 0;
  for (std::size_t i = 0; i < transitions.json->size() && !full(); ++i) {
    const auto item = element(transitions, i);
    const auto before = machine_.transitions.size();
    read_transition(item);
    if (machine_.transitions.size() == before) continue;
    const auto& transition = machine_.transitions.back();
    if (!transition.id.empty() && !ids.insert(transition.id).second)
      problem(member(item, "id"), fmt::format("a second transition with the id {}", in_quotes(transition.id)));
    arcs += transition.from.size() * (transition.on ? transition.on->names.size() + 1 : 1);
    if (arcs > most_arcs)
      return problem(item, fmt::format("more than {} transitions, counted for each state and symbol", most_arcs));
  }
}

std::vector<StateIndex> MachineReader::read_origins(const Item& from) {
  std::vector<StateIndex> states;
  if (from.json && *from.json == "*") {
    for (StateIndex i = 0; i < machine_.states.size(); ++i) states.push_back(i);
  } else if (from.json && from.json->is_array()) {
    if (from.json->empty()) problem(from, "found an empty list, expected a state, a list of states or \"*\"");
    std::set<StateIndex> seen;
    for (std::size_t i = 0; i < from.json->size(); ++i) {
      const auto problems = problems_.size();
      const auto state = state_named(element(from, i));
      if (seen.insert(state).second)
        states.push_back(state);
      else if (problems_.size() == problems)
        problem(element(from, i), fmt::format("{} a second time", in_quotes(machine_.states[state].name)));
    }
  } else {
    states.push_back(state_named(from));
  }
  return states;
}

void MachineReader::read_transition(const Item& item) {
  if (!expect_object(item, "a transition")) return;
  Transition transition;
  transition.id = name_of(required(item, "id", "a name for the transition"), "a name for the transition");
  transition.from = read_origins(required(item, "from", "a state, a list of states or \"*\""));
  const auto on = required(item, "on", "input symbols, or null for an ε-transition");
  if (on.json && !on.json->is_null()) {
    transition.on = read_symbols(on);
    transition.on_text = on.json->is_string() ? on.json->get<std::string>() : compact(*on.json);
  }
  if (const auto when = member(item, "when"); when.json) transition.when = parse(when, Type::truth());
  transition.to = state_named(required(item, "to", "the state to enter"));
  transition.operation = read_operation(item);
  transition.weight = number_of(member(item, "weight"), "a weight", 1, 0, 1e9);
  if (transition.weight == 0) mismatch(member(item, "weight"), "a weight, a number greater than 0");
  transition.effects = read_effects(member(item, "do"));
  machine_.transitions.push_back(std::move(transition));
}

}  // namespace continua
