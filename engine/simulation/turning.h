// Turns of an object about the vertical, on the spot.
#pragma once

#include <optional>
#include <vector>

#include "continua/simulation/handling.h"

namespace continua {

/// The best handling that turns the task's object by `by_rad`, either way round, and sets it down on the spot. `grasp`:
/// the hand's hold on the object, if any. Grips like those `tried` come last. Without `has_room` the object would turn
/// into other things, or the fingers have no room; without `reached` arm and wrist do not get that far. Nothing if
/// there is no way to hold the object.
std::optional<Handling> plan_turn(const Task& task, double by_rad, const WorldSnapshot& world, const Means& means,
                                  const std::optional<Grasp>& grasp, const std::vector<Grip>& tried);

}  // namespace continua
