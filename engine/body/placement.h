// The place where an object comes to lie when it is brought to a goal.
#pragma once

#include <functional>

#include <string>

#include "continua/body/avatar_command.h"
#include "continua/body/reason.h"

namespace continua {

/// Whether the hand gets to a point of the world; empty: it gets everywhere.
using Reaches = std::function<bool(const Vec3& p_W)>;

struct Placement {
  Vec3 p_WO = Vec3::Zero();  ///< the object's centre, on the grid
  bool upright = false;      ///< the object is stood on its end, its longest side vertical
};

/// Treatment of a goal where other things stand.
enum class Occupied {
  avoided,  ///< the place is the one nearest to the ideal place where the object overlaps nothing, on the table
  cleared,  ///< the body makes room: for a point, a side and the top of a thing the place is the ideal one
};

/// The place of the object when `command`, a put, slide, push or move, succeeds in `world`, or the reason why there is
/// none. The relation (world/relations.h) holds at the place.
///
/// - A point: on the table, whatever stands there.
/// - left, right, in_front, behind, touching: ideally the object touches the landmark.
/// - at, beside: next to the landmark; near, between: at some distance from it.
/// - in: on the hollow's floor, lying if there is room, else upright.
/// - In front of a participant: near the edge of the table, or as near to it as the hand gets.
/// - A side of the object itself: one step in that direction.
///
/// Of several places beside the landmark one is preferred where `reaches` is true of the object's centre: the hand gets
/// there. REQUIRES that no thing of the command is missing.
OrReason<Placement> placement(const AvatarCommand& command, const WorldSnapshot& world, Occupied occupied,
                              const Reaches& reaches = {});

/// A reason of that code about an object, the goal's landmarks and its relation in words ("in front"). REQUIRES that
/// the goal has a relation.
Reason reason_about_goal(ReasonCode code, const std::string& object, const Goal& goal);

}  // namespace continua
