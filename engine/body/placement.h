// The place where an object comes to lie when it is brought to a goal.
#pragma once

#include <string>

#include "continua/body/avatar_command.h"
#include "continua/body/reason.h"

namespace continua {

struct Placement {
  Vec3 p_WO = Vec3::Zero();  ///< the object's centre, on the grid
  bool upright = false;      ///< the object is stood on its end, its longest side vertical
};

/// Who deals with things that already stand at the goal.
enum class Occupied {
  avoided,  ///< the caller: the place is the one nearest to the ideal where the object overlaps nothing, on the table
  cleared,  ///< the body, which makes room: for a point, a side and the top of a thing the place is the ideal one
};

/// The place of the object when `command`, a put, slide, push or move, succeeds in `world`. At a point it stands on the
/// table, whatever is there. Beside another thing (left, right, in_front, behind, touching) it ideally touches that
/// thing, for `at` and `beside` it stands next to it, for `near` and `between` it keeps a distance. For `in` it stands
/// on the hollow's floor, lying if it fits so, else upright. In front of a participant it is near the edge of the
/// table. A side of the object itself is a step that way. The relation holds at every place returned, by
/// world/relations. The reason says why there is no such place. REQUIRES that nothing is missing.
OrReason<Placement> placement(const AvatarCommand& command, const WorldSnapshot& world, Occupied occupied);

/// A reason of that code about an object, the goal's landmarks and its relation in words ("in front"). REQUIRES that
/// the goal has a relation.
Reason reason_about_goal(ReasonCode code, const std::string& object, const Goal& goal);

}  // namespace continua
