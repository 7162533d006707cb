#include "continua/replay/recorder/machine_graph.h"

#include "continua/term/term_text.h"

namespace continua {
namespace {

// For gates and edges: an operation's name, and its content in the machine file if it has one.
template <class T>
void add_operation(T& told, const Operation& operation) {
  const auto source = Json::parse(operation.source);
  told.operation = source.begin().key();
  if (operation.kind != Operation::Kind::none) told.content = {compact(source.begin().value())};
}

log::GraphState state_of(const State& state, const Machine& machine) {
  log::GraphState told{.id = state.name, .accepting = state.accepting, .gate = {}};
  if (!state.gate) return told;
  auto& gate = told.gate.emplace();
  gate.condition = print(state.gate->when);
  gate.otherwise = machine.states[state.gate->otherwise].name;
  add_operation(gate, state.gate->operation);
  return told;
}

}  // namespace

log::Graph graph_of(const Machine& machine) {
  log::Graph graph;
  for (const auto& state : machine.states) graph.states.push_back(state_of(state, machine));
  graph.start = machine.states[machine.start].name;
  for (const auto& transition : machine.transitions)
    for (const auto from : transition.from) {
      log::GraphEdge edge{.id = transition.id,
                          .from = machine.states[from].name,
                          .to = machine.states[transition.to].name,
                          .input = transition.on ? transition.on_text : "ε",
                          .condition = {},
                          .weight = transition.weight,
                          .operation = {},
                          .content = {}};
      if (transition.when) edge.condition.emplace(print(*transition.when));
      add_operation(edge, transition.operation);
      graph.edges.push_back(std::move(edge));
    }
  return graph;
}

}  // namespace continua
