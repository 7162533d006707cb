// Grips on an object with room for the fingers.
#pragma once

#include <vector>

#include "continua/simulation/avatar_form.h"
#include "continua/simulation/hand_turn.h"
#include "continua/simulation/object_shape.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// A way to hold an object and to turn with it on the way to a goal.
struct Grip {
  HandTurn hand;                ///< at the object
  Vec3 p_OT = Vec3::Zero();     ///< point between the pads, from the object's centre, in W
  double turn = 0;              ///< turn of hand and object about the vertical on the way to the goal, radians
  double tip = 0;               ///< turn about the closing direction before that, as the hand tilts, radians
  Vec3 aside_W = Vec3::Zero();  ///< the leaning object's centre is beside the goal by this
  double opening_m = 0;         ///< of each finger before they close and after they open
  double conflict_m = 0;        ///< deepest overlap of hand and other things; 0: there is room
  double cost = 0;              ///< orders grips without conflict: the cheaper is more natural
};

/// The hand's pose with the object's centre at `p_WO`, before or after the turn.
Pose hand_at(const Grip& grip, const Vec3& p_WO, bool turned);

/// The yaw along the world's axes that is nearest to `yaw`.
double straightened(double yaw);

/// All grips on the object as it stands, cheapest first: down on two of its sides, or with one finger below an edge
/// that sticks out. None if the object is wider than the hand and has no such edge. Without `shape` the object is its
/// box. Grips at the first of `parts` that the object has are cheaper.
std::vector<Grip> grips_on(const ObjectState& object, const WorldSnapshot& world, const AvatarForm& avatar,
                           const ObjectShape* shape = nullptr, const std::vector<std::string>& parts = {});

/// The grip with each possible turn that brings the object along the world's axes. Conflicts include the hand's at
/// `p_WG`. The hand may be in the hollow of the object named `into`.
std::vector<Grip> grips_at(const Grip& grip, const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world,
                           const AvatarForm& avatar, const std::string& into = "");

/// The grip with each possible turn that stands the object on its end, held near the other end. The object leans as far
/// as the hollow has room, so that the open hand lets it fall that way.
std::vector<Grip> grips_on_end(const Grip& grip, const ObjectState& object, const Vec3& p_WG,
                               const WorldSnapshot& world, const AvatarForm& avatar, const std::string& into);

}  // namespace continua
