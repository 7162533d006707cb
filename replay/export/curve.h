// Bézier curves as a layout gives them: cut where they leave a state, and what of them an arrow's head needs.
#pragma once

#include <vector>

#include "continua/replay/export/graph_layout.h"

namespace continua {

/// A box with rounded ends.
struct Pill {
  PagePoint centre;
  double width = 0, height = 0;

  /// Distance to its outline; negative inside.
  double distance(const PagePoint& p) const;
};

/// 1 + 3 k points.
using Curve = std::vector<PagePoint>;

/// What of the curve comes after it is first further than `distance` from the pill; empty if it never is.
Curve after_leaving(const Curve& curve, const Pill& pill, double distance);

/// What comes before it is last further than `distance` from the pill; empty if it never is.
Curve before_entering(const Curve& curve, const Pill& pill, double distance);

}  // namespace continua
