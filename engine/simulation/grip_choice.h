// How the hand takes hold of an object from above so that its fingers find room, where the object is and where it shall
// go.
#pragma once

#include <optional>

#include "world/world_snapshot.h"

namespace continua {

/// The hand's measures, metres, seen with the palm up and the point between the pads at the origin. They are those of
/// mjcf/avatar; heights are above that point.
struct HandShape {
  double finger_half_width_m = 0.009;  ///< across the closing direction
  double finger_thickness_m = 0.005;   ///< along it
  double finger_tip_m = -0.02;         ///< height of the finger's end
  double palm_bottom_m = 0.1, palm_top_m = 0.14;
  double palm_half_length_m = 0.062;  ///< along the closing direction
  double palm_half_width_m = 0.022;
  double widest_opening_m = 0.058;  ///< of one finger, from the middle
};

struct Grip {
  double yaw = 0;            ///< of the closing direction in W, radians, where the object is
  double turn = 0;           ///< by which hand and object turn on the way to the goal, radians
  Vec3 p_OT = Vec3::Zero();  ///< point between the pads from the object's centre, in W, where the object is
  double opening_m = 0;      ///< of each finger before they close and after they open
  double conflict_m = 0;     ///< how deep hand and other things would overlap; 0: there is room
};

/// The grip with least conflict, and of those the one with least turning of the wrist. `p_WG` is the centre's goal, if
/// the object is to be moved. `base_W` is the arm's first axis, which tells how far the wrist must turn. Nothing if the
/// object is wider than the hand.
std::optional<Grip> choose_grip(const ObjectState& object, const WorldSnapshot& world, const std::optional<Vec3>& p_WG,
                                const Vec3& base_W, const HandShape& hand = {});

/// Yaw of the closing direction at `p_W` when the last hinge is at zero and the fingers point down.
double natural_yaw(const Vec3& p_W, const Vec3& base_W);

/// How deep two boxes overlap, metres; 0 when they do not.
double overlap_depth(const Box& a, const Box& b);

/// The objects that stand on `object`, directly or on one another.
std::vector<std::string> standing_on(const ObjectState& object, const WorldSnapshot& world);

}  // namespace continua
