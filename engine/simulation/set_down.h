// Where and how an object is set down when something already stands where it shall go.
#pragma once

#include <optional>

#include "world/world_snapshot.h"

namespace continua {

struct SetDown {
  Vec3 p_WO = Vec3::Zero();          ///< the object's centre in the end
  std::optional<Vec3> shove_from_W;  ///< it is set down here first, and then pushes its way to p_WO
};

/// The way that brings the object's centre nearest to `p_WG` on the table plane:
/// into the goal if it is free; within `near_m` beside it if that is free; on top of what stands there if that bears
/// it; else along the table into the goal, pushing aside what stands there; and if that would push something off the
/// table, at the nearest free place. What stands on the object, and so moves along, is in nobody's way.
SetDown choose_set_down(const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world, double near_m);

}  // namespace continua
