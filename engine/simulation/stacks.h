// Things on top of each other.
#pragma once

#include <string>
#include <vector>

#include "continua/world/world_snapshot.h"

namespace continua {

/// The objects that stand on `object`, directly or on one another.
std::vector<std::string> standing_on(const ObjectState& object, const WorldSnapshot& world);

/// All objects without `object` and the things on it: possible obstacles for its motion.
std::vector<const ObjectState*> apart_from(const ObjectState& object, const WorldSnapshot& world);

/// Height of the highest thing under the footprint of an object.
double height_under(const ObjectState& object, const WorldSnapshot& world);

}  // namespace continua
