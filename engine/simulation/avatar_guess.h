// The hand of an arm that has no element of mjcf/README.md, as far as its model shows: which bodies are fingers, which
// geoms press, where the grip is and where it looks.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/simulation/mujoco_model.h"
#include "continua/world/geometry.h"

namespace continua {

/// The two bodies on a limited slide joint each that one body below `hand` carries (0: any body); nothing if there is
/// no such pair, or more than one.
std::optional<std::array<int, 2>> guess_fingers(const mjModel& model, int hand);

/// The geom of a finger that faces the other finger: the largest of the foremost faces of its outer half.
std::optional<int> guess_pad(const mjModel& model, int finger, int other_finger);

/// The nearest body that carries both bodies.
int carrier_of(const mjModel& model, int body, int other_body);

/// The grip's frame in the body `hand`: between the pads, x out of the palm, y the way the pads close.
Pose guess_grip(const mjModel& model, int hand, const std::array<int, 2>& pads);

}  // namespace continua
