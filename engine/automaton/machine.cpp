#include "continua/automaton/machine.h"

#include <algorithm>
#include <array>

namespace continua {

Term empty_value(const Type& type) {
  return type.kind() == Type::Kind::list ? Term::list({}, type.element()) : Term::null();
}

std::string name_of(Lesson lesson) {
  constexpr std::array names{"gesture", "word", "noun"};
  return names[static_cast<std::size_t>(lesson)];
}

namespace {

void visit_rewrites(const std::vector<Effect>& effects, const auto& visit) {
  for (const auto& effect : effects) {
    if (const auto* rewrite = std::get_if<Rewrite>(&effect.what)) visit(rewrite->operation);
    if (const auto* group = std::get_if<Group>(&effect.what)) visit_rewrites(group->effects, visit);
  }
}

void bind_names(Machine& machine) {
  using From = Binding::From;
  auto& bindings = machine.bindings;
  for (const auto& [name, index] : machine.slot_index) bindings[Name(name)] = {From::slot, index, {}, nullptr};
  for (const auto& [name, index] : machine.register_index) bindings[Name(name)] = {From::memory, index, {}, nullptr};
  for (const auto& [name, term] : machine.definitions) bindings[Name(name)] = {From::definition, 0, term, nullptr};
  for (const auto& [name, from] : {std::pair("in_state", From::in_state),
                                   {"input", From::input},
                                   {"confidence", From::confidence},
                                   {"now", From::now},
                                   {"looked_at", From::looked_at}})
    bindings.try_emplace(Name(name), Binding{from, 0, {}, nullptr});
  for (const auto& carried : carried_terms())
    if (!carried.understood || !machine.lexicon.empty())
      bindings.try_emplace(Name(carried.name), Binding{From::carried, 0, {}, carried.term});
}

void index_takers(Exits& exits, std::size_t transition, const SymbolSet& on) {
  const auto add = [&](std::vector<std::size_t>& takers) {
    if (takers.empty() || takers.back() != transition) takers.push_back(transition);
  };
  for (const auto& name : on.names) add(exits.by_name.find(name)->second);
  if (on.prefixes.empty()) return;
  add(exits.by_prefix);
  for (auto& [symbol, takers] : exits.by_name)
    if (on.contains(symbol)) add(takers);
}

void index_exits(Machine& machine) {
  machine.exits.assign(machine.states.size(), {});
  for (std::size_t i = 0; i < machine.transitions.size(); ++i) {
    const auto& transition = machine.transitions[i];
    for (const auto from : transition.from) {
      auto& exits = machine.exits[from];
      if (!transition.on)
        exits.epsilon.push_back(i);
      else
        for (const auto& name : transition.on->names) exits.by_name.try_emplace(name);
    }
  }
  for (std::size_t i = 0; i < machine.transitions.size(); ++i)
    for (const auto from : machine.transitions[i].from)
      if (machine.transitions[i].on) index_takers(machine.exits[from], i, *machine.transitions[i].on);
}

}  // namespace

void visit_operations(const Machine& machine, const std::function<void(const Operation&)>& visit) {
  for (const auto& transition : machine.transitions) {
    visit(transition.operation);
    visit_rewrites(transition.effects, visit);
  }
  for (const auto& state : machine.states) {
    if (state.gate) visit(state.gate->operation);
    visit_rewrites(state.enter, visit);
  }
  for (const auto& row : machine.implied)
    for (const auto& operation : row.operations) visit(operation);
}

void Machine::index() {
  index_exits(*this);
  bind_names(*this);
  landmark.assign(states.size(), std::nullopt);
  landmarks = 0;
  visit_operations(*this, [this](const Operation& operation) {
    if (operation.kind == Operation::Kind::pop_until && !landmark[operation.state])
      landmark[operation.state] = landmarks++;
  });
}

const Thresholds* Machine::thresholds_of(std::string_view symbol) const {
  const auto found = std::find_if(confidence.begin(), confidence.end(),
                                  [&](const auto& each) { return each.inputs.contains(symbol); });
  return found == confidence.end() ? nullptr : &*found;
}

bool Machine::knows_input(std::string_view symbol) const {
  return std::any_of(transitions.begin(), transitions.end(),
                     [&](const Transition& transition) { return transition.on && transition.on->contains(symbol); });
}

}  // namespace continua
