// What happens where an object is put down on a place that is partly taken, as far as boxes can tell.
#pragma once

#include <string>

#include "continua/world/world_snapshot.h"

namespace continua {

/// The world once `object`, which was just put down, and what it overlaps have pushed each other apart along the table:
/// the deepest overlap first, the shorter way, both by the same length, and so on for what they then overlap. What is
/// in the hollow of a thing goes along with it; what stands on it stays where it is, as it does when its support is
/// moved away at once, and falls if nothing is left below it. After a few hundred pushes some overlap may be left.
WorldSnapshot pushed_apart(WorldSnapshot world, const std::string& object);

}  // namespace continua
