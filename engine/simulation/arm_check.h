// Sentences about an arm that is complete and yet does less than it could: for `continua validate`, as nothing else
// tells whoever wrote the arm.
#pragma once

#include <string>
#include <vector>

#include "continua/simulation/scene.h"

namespace continua {

/// Geoms in front of the pads, objects and places out of reach, servos that do not follow. Empty if all is well, or if
/// the scene has no arm by the rules of mjcf/README.md. Moves each hinge in the simulation, which takes a second.
std::vector<std::string> arm_notes(const Scene& scene);

}  // namespace continua
