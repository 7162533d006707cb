// Bounding boxes of geoms and bodies.
#pragma once

#include <vector>

#include <mujoco/mujoco.h>

#include "continua/world/geometry.h"

namespace continua {

/// The vector of three numbers of MuJoCo.
inline Vec3 vec(const mjtNum* v) { return {v[0], v[1], v[2]}; }

/// Bounding box of all geoms of a body, in the body's frame B; empty boxes for bodies without geoms.
Box body_bounds_B(const mjModel& model, int body);

/// A bounding box of a geom, along the geom's own axes.
struct GeomBox {
  Pose X_BG;  ///< in the frame of the geom's body
  Vec3 half_m = Vec3::Zero();
};
GeomBox geom_box_B(const mjModel& model, int geom);

/// The corners of a box whose centre is at `X_AG`, in the frame A.
std::vector<Vec3> corners_A(const Pose& X_AG, const Vec3& half_m);

/// Corners of the bounding boxes of the geoms that can touch anything, in the body's frame.
std::vector<Vec3> body_corners_B(const mjModel& model, int body);

}  // namespace continua
