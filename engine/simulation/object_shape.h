// What of an object's form matters to fingers that come from above: how high it is where, and what is free below.
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
  /// Of the geoms of a body that can touch anything. Its box sites BODY_NAME are its components.
  static ObjectShape of_body(const mjModel_& model, int body, const Vec3& half_extents_m);

  /// How far a slice of the object reaches along x (`side` 0) or y (1).
  struct Slice {
    double min_m = 0, max_m = 0;
  };
  /// The slice across the other axis around `at_m`, `half_width_m` to each side, of what rises above `above_m`.
  /// Nothing where that is nothing.
  std::optional<Slice> slice(int side, double at_m, double half_width_m, double above_m) const;

  /// An edge that sticks out, under which there is air.
  struct Edge {
    double direction = 0;  ///< from the object's centre, radians
    double radius_m = 0;   ///< how far out it is
    double bottom_m = 0;   ///< highest of its underside, a finger's breadth
    double top_m = 0;      ///< highest of its top
  };
  /// Those no thicker than `thickest_m` and with at least `air_m` below, at `inset_m` from their outline.
  std::vector<Edge> edges(double inset_m, double half_width_m, double thickest_m, double air_m) const;

  /// Seen from above it is much the same however it is turned.
  bool is_round() const;

  double bottom_m() const { return -half_.z(); }

  /// The first of these components that the object has, as a box; null if it has none.
  const Box* part(const std::vector<std::string>& names) const;

 private:
  struct Column {
    double bottom_m = 0, top_m = 0;
    bool empty = true;
  };
  Vec3 center(int ix, int iy) const;
  const Column* at(double x, double y) const;

  Vec3 half_ = Vec3::Zero();
  int nx_ = 0, ny_ = 0;
  std::vector<Column> columns_;
  std::map<std::string, Box> parts_;
};

/// By the object's name.
using ObjectShapes = std::map<std::string, ObjectShape>;

}  // namespace continua
