// A state graph in Graphviz's language, for layouts and formats of other programs.
#pragma once

#include <string>

#include "continua/replay/export/state_graph.h"

namespace continua {

/// The same graph gives the same bytes.
std::string dot_of(const StateGraph& graph);

}  // namespace continua
