// The legend of a picture's numbers.
#pragma once

#include <vector>

#include "continua/replay/export/arrow_labels.h"
#include "continua/replay/export/svg_canvas.h"

namespace continua {

/// Each number with its arrow's states and full labels, in as many columns as are legible in `width` pixels.
SvgCanvas legend_of(const StateGraph& graph, const std::vector<Arrow>& arrows, const std::vector<ArrowLabel>& labels,
                    double width);

}  // namespace continua
