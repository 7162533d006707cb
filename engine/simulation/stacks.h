// What stands on what.
#pragma once

#include <string>
#include <vector>

#include "continua/world/world_snapshot.h"

namespace continua {

/// The objects that stand on `object`, directly or on one another.
std::vector<std::string> standing_on(const ObjectState& object, const WorldSnapshot& world);

/// All objects but `object` and what stands on it: what it can meet when it is moved.
std::vector<const ObjectState*> apart_from(const ObjectState& object, const WorldSnapshot& world);

/// Top of the highest thing under the footprint of an object.
double height_under(const ObjectState& object, const WorldSnapshot& world);

}  // namespace continua
