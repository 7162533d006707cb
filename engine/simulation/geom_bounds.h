// How far the geoms of a body reach.
#pragma once

#include <mujoco/mujoco.h>

#include "world/geometry.h"

namespace continua {

/// Bounding box of all geoms of a body, in the body's frame B; empty boxes for bodies without geoms.
Box body_bounds_B(const mjModel& model, int body);

}  // namespace continua
