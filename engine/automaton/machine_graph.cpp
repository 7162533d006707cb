// Input sets, states and transitions of a machine file.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "automaton/machine_reader.h"

namespace continua {

void MachineReader::read_inputs(const Item& inputs) {
  if (!inputs.json || !expect_object(inputs, "inputs")) return;
  for (const auto& [name, value] : inputs.json->items()) {
    std::vector<std::string> path;
    named_set(inputs, name, path);
  }
}

// A set may name other sets; `path` holds the names that are being read, to find one that contains itself.
const SymbolSet& MachineReader::named_set(const Item& inputs, const std::string& name, std::vector<std::string>& path) {
  if (const auto known = sets_.find(name); known != sets_.end()) return known->second;
  const auto item = member(inputs, name);
  SymbolSet set;
  if (std::find(path.begin(), path.end(), name) != path.end()) {
    problem(item, fmt::format("the set '{}' contains itself", name));
  } else if (expect_array(item, "a set of input symbols")) {
    path.push_back(name);
    for (std::size_t i = 0; i < item.json->size(); ++i) {
      const auto symbol = text_of(element(item, i), "an input symbol");
      if (inputs.json->contains(symbol))
        set.add(named_set(inputs, symbol, path));
      else
        set.add(symbol);
    }
    path.pop_back();
  }
  return sets_.emplace(name, std::move(set)).first->second;
}

SymbolSet MachineReader::read_symbols(const Item& item) {
  SymbolSet set;
  const auto add = [&](const Item& one) {
    const auto symbol = text_of(one, "an input symbol or the name of a set");
    if (const auto named = sets_.find(symbol); named != sets_.end())
      set.add(named->second);
    else
      set.add(symbol);
  };
  if (item.json && item.json->is_array())
    for (std::size_t i = 0; i < item.json->size(); ++i) add(element(item, i));
  else
    add(item);
  return set;
}

// States are known before transitions are read: those declared, then those transitions lead from or to.
void MachineReader::read_state_names(const Item& root) {
  const auto add = [&](const Json& name) {
    if (name.is_string() && name != "*" && state_index_.emplace(name.get<std::string>(), machine_.states.size()).second)
      machine_.states.push_back({name.get<std::string>(), false, std::nullopt, {}});
  };
  if (const auto states = member(root, "states"); states.json && states.json->is_object())
    for (const auto& [name, value] : states.json->items()) add(Json(name));
  const auto transitions = member(root, "transitions");
  if (!transitions.json || !transitions.json->is_array()) return;
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

StateIndex MachineReader::state_named(const Item& item) {
  const auto name = text_of(item, "a state");
  if (const auto found = state_index_.find(name); found != state_index_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& state : machine_.states) known.push_back(state.name);
  if (!name.empty()) problem(item, fmt::format("unknown state '{}'{}", name, did_you_mean(name, known)));
  if (machine_.states.empty()) machine_.states.push_back({name, false, std::nullopt, {}});
  return 0;
}

void MachineReader::read_states(const Item& states) {
  if (!states.json || !expect_object(states, "states")) return;
  for (const auto& [name, value] : states.json->items()) {
    const auto item = member(states, name);
    if (!expect_object(item, "a state", {"gate", "enter", "about", "layout"})) continue;
    auto& state = machine_.states[state_index_.at(name)];
    if (const auto gate = member(item, "gate"); gate.json) {
      if (!expect_object(gate, "a gate",
                         {"when", "else", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until",
                          "none", "about"}))
        continue;
      const auto when = parse(member(gate, "when"), Type::truth());
      const auto otherwise = state_named(member(gate, "else"));
      if (when) state.gate = Gate{*when, otherwise, read_operation(gate)};
    }
    if (const auto enter = member(item, "enter"); enter.json) state.enter = read_effects(enter);
  }
}

void MachineReader::read_transitions(const Item& transitions) {
  if (!transitions.json) return problem({&document_.root(), ""}, "expected \"transitions\", a list");
  if (!expect_array(transitions, "the transitions")) return;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < transitions.json->size(); ++i) {
    const auto item = element(transitions, i);
    const auto before = machine_.transitions.size();
    read_transition(item);
    if (machine_.transitions.size() > before && !ids.insert(machine_.transitions.back().id).second)
      problem(member(item, "id"), fmt::format("a second transition with the id '{}'", machine_.transitions.back().id));
  }
}

void MachineReader::read_transition(const Item& item) {
  if (!expect_object(item, "a transition",
                     {"id", "from", "on", "when", "to", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush",
                      "pop_until", "none", "weight", "do", "about"}))
    return;
  Transition transition;
  transition.id = text_of(member(item, "id"), "the transition's id");
  const auto from = member(item, "from");
  if (from.json && *from.json == "*") {
    for (StateIndex i = 0; i < machine_.states.size(); ++i) transition.from.push_back(i);
  } else if (from.json && from.json->is_array()) {
    for (std::size_t i = 0; i < from.json->size(); ++i) transition.from.push_back(state_named(element(from, i)));
  } else {
    transition.from.push_back(state_named(from.json ? from : item));
  }
  const auto on = member(item, "on");
  if (!on.json)
    problem(item, "expected \"on\": input symbols, or null for an ε-transition");
  else if (!on.json->is_null())
    transition.on = read_symbols(on);
  if (on.json && !on.json->is_null())
    transition.on_text = on.json->is_string() ? on.json->get<std::string>() : compact(*on.json);
  if (const auto when = member(item, "when"); when.json) transition.when = parse(when, Type::truth());
  transition.to = state_named(member(item, "to"));
  transition.operation = read_operation(item);
  transition.weight = number_of(member(item, "weight"), "a weight", 1);
  if (!(transition.weight > 0)) problem(member(item, "weight"), "a weight is greater than 0");
  if (const auto effects = member(item, "do"); effects.json) transition.effects = read_effects(effects);
  machine_.transitions.push_back(std::move(transition));
}

}  // namespace continua
