// How far the geoms of a body reach.
#pragma once

#include <vector>

#include <mujoco/mujoco.h>

#include "world/geometry.h"

namespace continua {

/// Bounding box of all geoms of a body, in the body's frame B; empty boxes for bodies without geoms.
Box body_bounds_B(const mjModel& model, int body);

/// Corners of boxes, one for each geom that can touch anything, that hold these geoms; in the body's frame.
std::vector<Vec3> body_corners_B(const mjModel& model, int body);

}  // namespace continua
