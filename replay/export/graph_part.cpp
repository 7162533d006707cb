#include "continua/replay/export/graph_part.h"

#include <fmt/format.h>

namespace continua {
namespace {

bool was_visited(std::optional<std::size_t> visits) { return visits.value_or(0) > 0; }

// The part of the states in `kept` and of the edges for which `wanted` holds.
template <class Wanted>
StateGraph part_of(const StateGraph& graph, const std::vector<bool>& kept, Wanted wanted) {
  StateGraph part{graph.name, std::nullopt, {}, {}};
  std::vector<std::size_t> places(graph.states.size());
  for (std::size_t i = 0; i < graph.states.size(); ++i) {
    if (!kept[i]) continue;
    places[i] = part.states.size();
    if (graph.start == i) part.start = places[i];
    part.states.push_back(graph.states[i]);
  }
  for (const auto& edge : graph.edges) {
    if (!kept[edge.to] || (edge.from && !kept[*edge.from]) || !wanted(edge)) continue;
    part.edges.push_back(edge);
    part.edges.back().to = places[edge.to];
    if (edge.from) part.edges.back().from = places[*edge.from];
  }
  return part;
}

}  // namespace

Result<StateGraph> part_with_states(const StateGraph& graph, const std::vector<std::string>& names) {
  if (names.empty()) return graph;
  std::vector<std::string> known;
  for (const auto& state : graph.states) known.push_back(state.name);
  std::vector<bool> kept(graph.states.size(), false);
  for (const auto& name : names) {
    std::size_t place = 0;
    while (place < known.size() && known[place] != name) ++place;
    if (place == known.size())
      return Error{"--states", fmt::format("found {}; expected states of {}{}", in_quotes(name), graph.name,
                                           did_you_mean(name, known))};
    kept[place] = true;
  }
  return part_of(graph, kept, [](const auto&) { return true; });
}

StateGraph visited_part(const StateGraph& graph) {
  std::vector<bool> kept(graph.states.size(), false);
  for (std::size_t i = 0; i < graph.states.size(); ++i)
    kept[i] = graph.start == i || was_visited(graph.states[i].visits);
  for (const auto& edge : graph.edges) {
    if (!was_visited(edge.visits)) continue;
    kept[edge.to] = true;
    if (edge.from) kept[*edge.from] = true;
  }
  return part_of(graph, kept, [](const auto& edge) { return was_visited(edge.visits); });
}

Result<StateGraph> visits_of_machine(const std::string& name, const RunIndex& run) {
  auto graph = state_graph_of(run);
  if (graph && graph->name != name)
    return Error{run.path(), fmt::format("is a run of the machine {}; expected one of {}", in_quotes(graph->name),
                                         in_quotes(name))};
  return graph;
}

}  // namespace continua
