// The world at one instant, as the engine sees it: a value, whatever moved it (MuJoCo or the kinematic world).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/world/geometry.h"

namespace continua {

/// One thing that can be talked about.
struct ObjectState {
  std::string name;                               ///< its body's name in the scene, unique
  std::map<std::string, std::string> attributes;  ///< what the scene says of it: "type" → "block", "color" → "red"
  Vec3 half_extents_m = Vec3::Zero();             ///< of its bounding box, in its own frame
  Vec3 p_WO = Vec3::Zero();                       ///< centre of its bounding box, on the grid
  double yaw = 0;                                 ///< radians
  /// The hollow of a container, open at its top: from p_WO, along the object's own axes. None where nothing can be put
  /// in, as into a cup that lies on its side.
  std::optional<Box> interior = {};

  /// Axis-aligned bounding box in W, yaw taken into account.
  Box bounds_W() const;
  /// The interior as a box along W's axes: if the object is turned, the largest one of its proportions that fits in it.
  std::optional<Box> interior_W() const;
};

struct WorldSnapshot {
  SimTime t;
  std::vector<ObjectState> objects;  ///< in the scene's order, which decides ties
  Box table;                         ///< the table's top; min.z = max.z = 0
  std::string held;                  ///< name of the object in the gripper, or empty

  /// The object of that name, or nullptr.
  const ObjectState* find(std::string_view name) const;
};

}  // namespace continua
