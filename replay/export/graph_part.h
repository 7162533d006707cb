// Parts of a state graph, for pictures that show less than a whole machine.
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/export/state_graph.h"

namespace continua {

/// The states of these names and the edges among them; an edge from every state stays where its target does. An error
/// with the nearest name if a state is unknown. No names: the whole graph.
Result<StateGraph> part_with_states(const StateGraph& graph, const std::vector<std::string>& names);

/// The states and edges that a run visited, and the start.
StateGraph visited_part(const StateGraph& graph);

/// The machine of a run with its visits, as the log has it. An error if that is not the machine of this name.
Result<StateGraph> visits_of_machine(const std::string& name, const RunIndex& run);

}  // namespace continua
