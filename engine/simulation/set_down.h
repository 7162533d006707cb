// Places and ways to set an object down where other things may stand.
#pragma once

#include <optional>
#include <vector>

#include "continua/world/world_snapshot.h"

namespace continua {

struct SetDown {
  Vec3 p_WO = Vec3::Zero();          ///< the object's centre at the end
  std::optional<Vec3> shove_from_W;  ///< the object is first set down here, then shoved to p_WO

  const Vec3& first_W() const { return shove_from_W ? *shove_from_W : p_WO; }
};

/// Ways to bring the object's centre to `p_WG` on the table plane, or at most `within_m` from there, best first: into
/// the goal; to a free place beside it; on top of the things there, if they bear the object; along the table into the
/// goal, with a shove for the things there, if none falls off. Things on the object move along and are in nobody's way.
/// The object comes to lie along the world's axes.
std::vector<SetDown> set_downs(const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world,
                               double within_m);

/// The object can stand at `p_W` on the table with nothing in its way, not even above.
bool is_free(const ObjectState& object, const Vec3& p_W, const WorldSnapshot& world);

/// The free places around `p_W`, nearest first, at most `most_m` away.
std::vector<Vec3> free_places(const ObjectState& object, const Vec3& p_W, const WorldSnapshot& world, double most_m,
                              double step_m);

}  // namespace continua
