// What stands on and in what, as far as it can be told from boxes.
#pragma once

#include <vector>

#include "continua/world/world_snapshot.h"

namespace continua {

/// Lengths below it are neither gap nor overlap: two roundings to the grid.
inline constexpr double grid_slack_m = 2 * position_grid_m;

/// Whether the thing is in the hollow of a container: within it as seen from above, and not below its floor.
bool is_inside(const ObjectState& thing, const ObjectState& container);

/// Whether two things are in each other, which what is in a hollow is not.
bool overlap(const ObjectState& a, const ObjectState& b);

/// For each object of the world, whether it goes along when the object of that name is moved: itself, what stands on it
/// or in it, and so on up.
std::vector<bool> carried_with(std::string_view object, const WorldSnapshot& world);

/// The height on which the object comes to stand if it is let go: the table, the floor of a hollow that it fits into,
/// or the top of what is below it and overlaps it most as seen from above.
double height_below(const ObjectState& object, const WorldSnapshot& world);

/// The object stood on its end: the longer of its sides becomes vertical.
ObjectState stood_on_end(ObjectState lying);

}  // namespace continua
