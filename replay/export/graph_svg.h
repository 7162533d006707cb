// A state graph as a picture that stands by itself: SVG, for light and dark pages and for paper.
#pragma once

#include <string>

#include "continua/core/result.h"
#include "continua/replay/export/picture_width.h"
#include "continua/replay/export/state_graph.h"

namespace continua {

/// States as rounded boxes, the start with an arrow from nowhere, accepting ones with a double ring; loops that consume
/// an input above their state, ε-loops below; dashed: where a gate sends the inputs that it does not let in. Parts that
/// a run did not visit are pale, lines that it took often are thick. No label is cut: where the width has no room for
/// it, its arrow has a number, and the label stands in a legend below; each arrow's labels stand in its tooltip too. At
/// most `width_mm` wide; text has 7 points at least, except in the drawing of a graph that is too large for that. The
/// same graph gives the same bytes. Graphs of more than 600 arrows, which would take minutes, are refused. Not to be
/// called from two threads at once.
Result<std::string> svg_of(const StateGraph& graph, double width_mm = page_width_mm);

}  // namespace continua
