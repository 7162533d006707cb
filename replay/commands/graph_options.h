// The options that pictures of machines and of runs share.
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/export/state_graph.h"

namespace CLI {
class App;
}

namespace continua {

struct GraphOptions {
  std::vector<std::string> states = {};  ///< empty: all
  std::string width = {};                ///< as picture_width() reads it; empty: that of a page
};

void add_graph_options(CLI::App& command, GraphOptions& options);

/// The graph as SVG, as wide as the options say. Errors: of their width, and those of svg_of().
Result<std::string> picture_of(const StateGraph& graph, const GraphOptions& options);

}  // namespace continua
