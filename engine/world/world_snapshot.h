// The world at one instant: a value, the same for MuJoCo and the kinematic world.
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
  std::map<std::string, std::string> attributes;  ///< from the scene: "type" → "block", "color" → "red"
  Vec3 half_extents_m = Vec3::Zero();             ///< of its bounding box, in its own frame
  Vec3 p_WO = Vec3::Zero();                       ///< centre of its bounding box, on the grid
  double yaw = 0;                                 ///< radians
  /// The hollow of a container, open at its top: from p_WO, along the object's own axes. Absent if nothing can be put
  /// in, as into a cup on its side.
  std::optional<Box> interior = {};

  /// Axis-aligned bounding box in W of the turned object.
  Box bounds_W() const;
  /// The interior as a box along W's axes: in a turned object the largest such box of the same proportions.
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
