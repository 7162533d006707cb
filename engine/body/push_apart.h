// Boxes that push each other apart after an object has been put down on a partly taken place.
#pragma once

#include <string>

#include "continua/world/world_snapshot.h"

namespace continua {

/// Which of two overlapping things gives way.
enum class GivesWay {
  both,    ///< half by each
  others,  ///< the thing that was put down stays at its place, as in a firm hand
};

/// The world after `object`, just put down, and the things that overlap it have pushed each other apart along the
/// table. The deepest overlap is resolved first, along its shorter way; then the overlaps that this causes. Things in a
/// hollow move along with it. Things on top stay where they are, as if their support had been pulled away, and fall if
/// nothing is left below them. After a few hundred pushes some overlap may remain.
WorldSnapshot pushed_apart(WorldSnapshot world, const std::string& object, GivesWay gives_way = GivesWay::both);

}  // namespace continua
