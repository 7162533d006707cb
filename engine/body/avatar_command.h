// One order to the avatar's body: the act, its object and its goal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/body/capability.h"
#include "continua/core/named_values.h"
#include "continua/world/relations.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// A destination. The body resolves the place when the act begins, because a landmark may have moved since the command.
struct Goal {
  std::optional<Relation> relation;               ///< to the landmarks; if absent, p_WG is the goal
  std::vector<std::string> landmarks;             ///< objects or participants, as many as landmarks_of(relation)
  Perspective perspective = Perspective::avatar;  ///< whose left, right, front and behind
  Vec3 p_WG = Vec3::Zero();                       ///< the point of the table under the object's centre
};

/// The side from which the hand comes to an object.
enum class Approach { any, above, side };

inline constexpr NamedValue<Approach> approach_names[] = {
    {Approach::any, ""}, {Approach::above, "above"}, {Approach::side, "side"}};

struct AvatarCommand {
  int id = 0;  ///< running number, returned in reports
  Capability what = Capability::signal;
  std::string object;             ///< target of the act; empty: the goal's place is the target
  Goal goal;                      ///< for put, slide, push and move; for reach, point, look without object: the place
  std::optional<Goal> next = {};  ///< for grasp: the object's next goal, for which the grip must do too
  std::vector<std::string> parts = {};  ///< for grasp: the components to hold it by, best first
  bool only_parts = false;              ///< for grasp: no other place will do
  Approach approach = Approach::any;    ///< for grasp
  double height_m = 0;                  ///< for lift
  double turn_rad = 0;                  ///< for turn: counterclockwise as seen from above
  std::string name;                     ///< for signal
};

/// The first object or participant of the command that the world lacks; nothing if the world has all.
std::optional<std::string> missing_thing(const AvatarCommand& command, const WorldSnapshot& world);

}  // namespace continua
