// A camera for a whole scene, from a given side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "continua/world/geometry.h"

namespace continua {

/// Names of the sides for a camera.
std::vector<std::string> side_names();

/// A free camera on that side with all `points_W` in the picture, above the part `free_below` of its height. `fovy`:
/// the camera's vertical angle in degrees; `aspect`: width by height. Nothing if there is no such side.
std::optional<mjvCamera> camera_from(const std::string& side, const std::vector<Vec3>& points_W, double fovy,
                                     double aspect, double free_below);

}  // namespace continua
