// Where and how an object is set down when something already stands where it shall go.
#pragma once

#include <optional>
#include <vector>

#include "continua/world/world_snapshot.h"

namespace continua {

struct SetDown {
  Vec3 p_WO = Vec3::Zero();          ///< the object's centre in the end
  std::optional<Vec3> shove_from_W;  ///< it is set down here first, and then pushes its way to p_WO

  const Vec3& first_W() const { return shove_from_W ? *shove_from_W : p_WO; }
};

/// The ways that bring the object's centre to `p_WG` on the table plane or at most `near_m` from it, best first:
/// into the goal; beside it, where that is free; on top of what stands there, if that bears it; along the table into
/// the goal, pushing aside what stands there and falls off nothing. What stands on the object, and so moves along, is
/// in nobody's way. The object comes to lie along the world's axes.
std::vector<SetDown> set_downs(const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world, double near_m);

/// Whether the object can stand at `p_W` on the table with nothing in its way, not even above.
bool is_free(const ObjectState& object, const Vec3& p_W, const WorldSnapshot& world);

/// The free places around `p_W`, nearest first, at most `most_m` away.
std::vector<Vec3> free_places(const ObjectState& object, const Vec3& p_W, const WorldSnapshot& world, double most_m,
                              double step_m);

}  // namespace continua
