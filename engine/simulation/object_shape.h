// The form of an object for fingers that come from above: heights, and free space below.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continua/world/geometry.h"

struct mjModel_;

namespace continua {

/// The form of an object as it stands upright, in vertical columns. Lengths are in its own frame, metres.
class ObjectShape {
 public:
  /// The shape of a body's geoms that can touch anything. The body's box sites BODY_NAME are the components.
  static ObjectShape of_body(const mjModel_& model, int body, const Vec3& half_extents_m);

  /// Extent of a slice of the object along x (`side` 0) or y (1).
  struct Slice {
    double min_m = 0, max_m = 0;
  };
  /// The slice at `at_m` on the other axis, `half_width_m` to each side, of the parts higher than `above_m`. Nothing if
  /// there are no such parts.
  std::optional<Slice> slice(int side, double at_m, double half_width_m, double above_m) const;

  /// An edge that sticks out, under which there is air.
  struct Edge {
    double direction = 0;  ///< from the object's centre, radians
    double radius_m = 0;   ///< distance from the centre
    double bottom_m = 0;   ///< lowest point of its underside, within a finger's breadth
    double top_m = 0;      ///< highest point of its top, there
  };
  /// Edges no thicker than `thickest_m` and with at least `air_m` below, at `inset_m` from their outline.
  std::vector<Edge> edges(double inset_m, double half_width_m, double thickest_m, double air_m) const;

  /// From above the object looks much the same in every turn.
  bool is_round() const;

  double bottom_m() const { return -half_.z(); }

  /// The box of the first of these components that the object has; null if it has none.
  const Box* part(const std::vector<std::string>& names) const;

 private:
  struct Column {
    double bottom_m = 0, top_m = 0;
    bool empty = true;
  };
  /// The middle of the `i`-th column along x (`axis` 0) or y (1).
  double center_m(int axis, int i) const;
  const Column* at(double x, double y) const;

  Vec3 half_ = Vec3::Zero();
  int nx_ = 0, ny_ = 0;
  std::vector<Column> columns_;
  std::map<std::string, Box> parts_;
};

/// Shapes by name of the object.
using ObjectShapes = std::map<std::string, ObjectShape>;

}  // namespace continua
