// The ways in which the hand can take hold of an object so that its fingers find room.
#pragma once

#include <vector>

#include "continua/simulation/avatar_form.h"
#include "continua/simulation/hand_turn.h"
#include "continua/simulation/object_shape.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// How the hand holds an object, and how both turn on the way to a goal.
struct Grip {
  HandTurn hand;                ///< where the object is
  Vec3 p_OT = Vec3::Zero();     ///< point between the pads from the object's centre, in W, where the object is
  double turn = 0;              ///< by which hand and object turn about the vertical on the way to the goal, radians
  double tip = 0;               ///< and before that about the closing direction, as the hand tilts
  Vec3 aside_W = Vec3::Zero();  ///< by how much the object's centre misses the goal, for it leans there
  double opening_m = 0;         ///< of each finger before they close and after they open
  double conflict_m = 0;        ///< how deep hand and other things would overlap; 0: there is room
  double cost = 0;              ///< of two grips without conflict, the cheaper is more natural
};

/// The hand's pose when the object's centre is at `p_WO` and has not yet been turned, or has.
Pose hand_at(const Grip& grip, const Vec3& p_WO, bool turned);

/// The yaw nearest to `yaw` that lies along the world's axes.
double straightened(double yaw);

/// Every way in which the hand can take the object as it stands, without turning it, cheapest first: down on two of its
/// sides, or with one finger below an edge that sticks out. None if it is wider than the hand and has no such edge.
/// Without `shape` the object is its box. By one of
/// `parts` it is held where it can be, the first that it has.
std::vector<Grip> grips_on(const ObjectState& object, const WorldSnapshot& world, const AvatarForm& avatar,
                           const ObjectShape* shape = nullptr, const std::vector<std::string>& parts = {});

/// The grip with each turn after which the object lies along the world's axes and that the wrist can make; with the
/// conflict that the hand has at `p_WG` too. The hand may be in the hollow of the object named `into`.
std::vector<Grip> grips_at(const Grip& grip, const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world,
                           const AvatarForm& avatar, const std::string& into = "");

/// The grip with each turn that stands the object on its end, held near the other, and that the wrist can make. It
/// leans as far as the hollow leaves room, so that it does not fall otherwise when the hand opens.
std::vector<Grip> grips_on_end(const Grip& grip, const ObjectState& object, const Vec3& p_WG,
                               const WorldSnapshot& world, const AvatarForm& avatar, const std::string& into);

}  // namespace continua
