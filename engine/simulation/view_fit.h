// A camera that takes in all of a scene, from a given side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "continua/world/geometry.h"

namespace continua {

/// The names of the sides that a camera may look from.
std::vector<std::string> side_names();

/// A free camera on that side from which `points_W` all lie within the picture, above its lowest part `free_below` (of
/// its height). `fovy` is the camera's vertical angle in degrees, `aspect` width by height. Nothing: there is no such
/// side.
std::optional<mjvCamera> camera_from(const std::string& side, const std::vector<Vec3>& points_W, double fovy,
                                     double aspect, double free_below);

}  // namespace continua
