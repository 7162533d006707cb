// One order to the avatar's body: the act, its object and its goal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/body/capability.h"
#include "continua/world/relations.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// A destination. The body resolves it when the act begins, because a landmark may have moved since it was named.
struct Goal {
  std::optional<Relation> relation;               ///< to the landmarks; without one, p_WG is the goal
  std::vector<std::string> landmarks;             ///< objects or participants, as many as landmarks_of(relation)
  Perspective perspective = Perspective::avatar;  ///< whose sides are meant
  Vec3 p_WG = Vec3::Zero();                       ///< the point of the table under the object's centre
};

struct AvatarCommand {
  int id = 0;  ///< running number, returned in reports
  Capability what = Capability::signal;
  std::string object;             ///< target of the act; empty: the goal's place is the target
  Goal goal;                      ///< for put, slide, push and move; for reach, point, look without object: the place
  std::optional<Goal> next = {};  ///< for grasp: where the object will go then, so that the grip suits that too
  std::vector<std::string> parts = {};  ///< for grasp: the components by which it is best held, best first
  double height_m = 0;                  ///< for lift
  double turn_rad = 0;                  ///< for turn: counterclockwise as seen from above
  std::string name;                     ///< for signal
};

/// The first object or participant of the command that is not in the world; nothing if all are.
std::optional<std::string> missing_thing(const AvatarCommand& command, const WorldSnapshot& world);

}  // namespace continua
