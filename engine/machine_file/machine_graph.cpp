#include "continua/machine_file/machine_graph.h"

#include <set>

#include <fmt/format.h>

#include "continua/machine_file/machine_keys.h"
#include "continua/machine_file/machine_weights.h"

namespace continua {
namespace {

// Arcs are counted one for each state and each symbol of a transition. More would exhaust the memory of the index.
constexpr std::size_t most_arcs = 1'000'000;

constexpr int highest_rank = 1000000;

}  // namespace

std::vector<State> GraphReader::states(const Item& item) {
  std::vector<State> states;
  for (const auto& name : names_.names()) states.push_back({name, false, std::nullopt, {}});
  for (const auto& [name, entry] : item.members("states")) {
    const auto index = names_.find(name);
    if (!index) {
      entry.problem_at_key(fmt::format("found {}, expected the name of a state", in_quotes(name)));
      continue;
    }
    names_.add_mention(name, entry);
    if (!expect_kind(entry, "a state")) continue;
    auto& state = states[*index];
    state.gate = gate(entry.member("gate"), name);
    state.enter = effects_.effects(entry.member("enter"));
    state.passing = entry.member("passing").truth(false);
  }
  return states;
}

std::optional<Gate> GraphReader::gate(const Item& item, const std::string& state) {
  if (!item.exists() || !expect_kind(item, "a gate")) return std::nullopt;
  const auto when = terms_.term(item.required("when", "the condition on which the state is entered"), Type::truth());
  const auto otherwise = item.required("else", "the state to enter where the condition does not hold");
  const auto leads_to = names_.named(otherwise);
  if (otherwise.is_text() && otherwise.json() == state)
    otherwise.problem("the gate of a state leads to that state itself; expected another one");
  auto operation = operations_.operation(item);
  if (!when) return std::nullopt;
  return Gate{*when, leads_to.value_or(0), std::move(operation)};
}

std::vector<Transition> GraphReader::transitions(const Item& item) {
  std::vector<Transition> transitions;
  std::set<std::string> ids;
  std::size_t arcs = 0;
  for (const auto& each : item.elements("the transitions")) {
    if (each.reader_is_full()) break;
    auto read = transition(each);
    if (!read) continue;
    if (!read->id.empty() && !ids.insert(read->id).second)
      each.member("id").problem(fmt::format("a second transition with the id {}", in_quotes(read->id)));
    arcs += read->from.size() * (read->on ? read->on->names.size() + 1 : 1);
    transitions.push_back(std::move(*read));
    if (arcs <= most_arcs) continue;
    each.problem(fmt::format("more than {} transitions, counted for each state and symbol", most_arcs));
    break;
  }
  return transitions;
}

std::vector<StateIndex> GraphReader::origins(const Item& from) {
  std::vector<StateIndex> states;
  if (from.is_text() && from.json() == "*") {
    for (StateIndex i = 0; i < names_.names().size(); ++i) states.push_back(i);
    return states;
  }
  if (!from.is_list()) return {names_.named(from).value_or(0)};
  const auto elements = from.elements("states");
  if (elements.empty()) from.problem("found an empty list, expected a state, a list of states or \"*\"");
  std::set<StateIndex> seen;
  for (const auto& each : elements) {
    const auto state = names_.named(each);
    if (!state) continue;
    if (seen.insert(*state).second)
      states.push_back(*state);
    else
      each.problem(fmt::format("{} a second time", in_quotes(names_.names()[*state])));
  }
  return states;
}

std::optional<Transition> GraphReader::transition(const Item& item) {
  if (!expect_kind(item, "a transition")) return std::nullopt;
  Transition transition;
  transition.id = item.required("id", "a name for the transition").name("a name for the transition");
  transition.from = origins(item.required("from", "a state, a list of states or \"*\""));
  const auto on = item.required("on", "input symbols, or null for an ε-transition");
  if (on.exists() && !on.json().is_null()) {
    transition.on = symbols_.symbols(on);
    transition.on_text = on.is_text() ? on.json().get<std::string>() : compact(on.json());
  }
  transition.when = terms_.term(item.member("when"), Type::truth());
  transition.to = names_.named(item.required("to", "the state to enter")).value_or(0);
  transition.operation = operations_.operation(item);
  transition.rank = item.member("rank").whole_number("a rank", 0, -highest_rank, highest_rank);
  const auto weight = item.member("weight");
  transition.weight = weight.number("a weight", 1, 0, heaviest_weight);
  if (transition.weight == 0) weight.mismatch("a weight, a number greater than 0");
  transition.effects = effects_.effects(item.member("do"));
  return transition;
}

std::vector<Implied> GraphReader::implied(const Item& item) {
  std::vector<Implied> rows;
  std::size_t number = 0;
  for (const auto& each : item.elements("what observed moves imply")) {
    ++number;
    if (!expect_kind(each, "what is implied")) continue;
    Implied row;
    row.number = number;
    row.when = terms_.term(each.member("when"), Type::truth());
    row.to = names_.named(each.required("to", "the state that the dialogue is in then")).value_or(0);
    for (const auto& operation : each.member("stack").elements("operations, one after the other"))
      if (expect_kind(operation, "an operation")) row.operations.push_back(operations_.operation(operation));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace continua
