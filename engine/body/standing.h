// Supports and contents of things, judged by their boxes.
#pragma once

#include <vector>

#include "continua/world/world_snapshot.h"

namespace continua {

/// A smaller length is neither gap nor overlap: two roundings to the grid.
inline constexpr double grid_slack_m = 2 * position_grid_m;

/// The thing is in the hollow of a container: within it as seen from above, and not below its floor.
bool is_inside(const ObjectState& thing, const ObjectState& container);

/// The table bears an object whose centre is there: it is above the table, so far from its edge.
bool bears(const Box& table, const Vec3& p_WO, double margin_m = 0.003);

/// The two boxes overlap, and neither thing is in the hollow of the other.
bool overlap(const ObjectState& a, const ObjectState& b);

/// For each object of the world: does it move along with the object of that name? The object itself does, things on or
/// in it do, and so on upward.
std::vector<bool> carried_with(std::string_view object, const WorldSnapshot& world);

/// The height of the support on which the object would land: the table, the floor of a hollow that it fits into, or the
/// top of the thing below it that overlaps it most as seen from above.
double height_below(const ObjectState& object, const WorldSnapshot& world);

/// The object stood on its end: the longer of its sides becomes vertical.
ObjectState stood_on_end(ObjectState lying);

}  // namespace continua
