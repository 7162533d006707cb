// Turning an object about the vertical, where it is.
#pragma once

#include <optional>
#include <vector>

#include "continua/simulation/handling.h"

namespace continua {

/// The best way to turn the task's object by `by_rad`, or so that it comes to be turned the same: which grip, which way
/// round. `grasp` is how the hand holds it if it does. Its set_down is where it is now. Grips like those `tried` come
/// last. Without `has_room` it would turn into other things, or fingers find none; without `reached` arm and wrist do
/// not get so far. Nothing if there is no way to hold the object.
std::optional<Handling> plan_turn(const Task& task, double by_rad, const WorldSnapshot& world, const Means& means,
                                  const std::optional<Grasp>& grasp, const std::vector<Grip>& tried);

}  // namespace continua
