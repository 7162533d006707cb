// Bézier curves from a layout: cut where they leave a state, with the data for an arrow's head.
#pragma once

#include <vector>

#include "continua/replay/export/graph_layout.h"

namespace continua {

/// A box with rounded ends, or rounded corners where it is high.
struct Pill {
  PagePoint centre;
  double width = 0, height = 0;

  double radius() const;

  /// Distance to its outline; negative inside.
  double distance(const PagePoint& p) const;
};

/// 1 + 3 k points.
using Curve = std::vector<PagePoint>;

/// Points of the curve from its begin to its end, `count` of each piece after the first point.
std::vector<PagePoint> points_along(const Curve& curve, std::size_t count);

/// The part of the curve after it is first farther than `distance` from the pill; empty if it never is.
Curve after_leaving(const Curve& curve, const Pill& pill, double distance);

/// The part before it is last farther than `distance` from the pill; empty if it never is.
Curve before_entering(const Curve& curve, const Pill& pill, double distance);

}  // namespace continua
