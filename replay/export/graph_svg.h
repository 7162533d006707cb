// A state graph as a picture that stands by itself: SVG, for light and dark pages.
#pragma once

#include <string>

#include "continua/core/result.h"
#include "continua/replay/export/state_graph.h"

namespace continua {

/// States as rounded boxes, the start with an arrow from nowhere, accepting ones with a double ring; loops that consume
/// an input above their state, ε-loops below; dashed: where a gate sends the inputs that it does not let in. Parts that
/// a run did not visit are pale. Each arrow's labels stand in full in its tooltip. The same graph gives the same bytes.
/// Graphs that cannot be laid out in reasonable time are refused. Not to be called from two threads at once.
Result<std::string> svg_of(const StateGraph& graph);

}  // namespace continua
