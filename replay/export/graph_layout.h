// Places for the parts of a graph: Graphviz's layout `dot`. Graphviz is used only here, and only
// its layout, so that neither its configuration nor the fonts of a machine have a say in it.
#pragma once

#include <cstddef>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct PagePoint {
  double x = 0, y = 0;
};

/// Sizes in pixels, y down.
struct LayoutNode {
  double width = 0, height = 0;  ///< nothing else is laid in this box
};
struct LayoutEdge {
  std::size_t from = 0, to = 0;              ///< two different nodes
  double label_width = 0, label_height = 0;  ///< 0: no label
};

struct PlacedEdge {
  std::vector<PagePoint> curve;  ///< from centre to centre; Bézier: 1 + 3 k points
  PagePoint label;               ///< its centre
};
struct Layout {
  std::vector<PagePoint> nodes;  ///< centres
  std::vector<PlacedEdge> edges;
};

/// The way in which ranks follow one another, and the room between boxes, in pixels.
struct LayoutStyle {
  bool downward = false;  ///< else from left to right
  double between_ranks = 14.4, between_nodes = 10.8;
};

/// All arrows of `first` are laid onward from it. Large graphs get straight lines; their number of edges
/// is the caller's to limit. The same input gives the same layout. Not to be called from two threads at once: Graphviz
/// keeps its state in variables of its own.
Result<Layout> lay_out(const std::vector<LayoutNode>& nodes, const std::vector<LayoutEdge>& edges, std::size_t first,
                       const LayoutStyle& style = {});

}  // namespace continua
