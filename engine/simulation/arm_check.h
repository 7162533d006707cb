// Sentences about an arm that is complete and yet does less than it could: for `continua validate`, as nothing else
// tells whoever wrote the arm.
#pragma once

#include <string>
#include <vector>

#include "continua/simulation/scene.h"

namespace continua {

/// Geoms in front of the pads, objects and places out of reach, servos that do not follow. Empty if all is well, or if
/// the scene has no arm by the rules of mjcf/README.md. Moves each hinge in the simulation, which takes a fraction of a
/// second; of a world whose physics takes longer than `longest_s` of a processor, it says that servos were not tried.
std::vector<std::string> arm_notes(const Scene& scene, double longest_s = 8);

/// Sentences about elements of the arm that its scene does not tell and that were guessed, each with file and line.
/// Empty if the scene has them all, or has no file.
std::vector<std::string> guesses_about_avatar(const Scene& scene);

}  // namespace continua
