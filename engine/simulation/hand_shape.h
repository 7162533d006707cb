// The hand as what it takes up: how it is held, and how deep it would be in other things.
#pragma once

#include <vector>

#include "simulation/oriented_box.h"
#include "world/geometry.h"

namespace continua {

/// The hand's measures, metres, from the point between the pads; `back` is along the fingers, toward the wrist. They
/// are those of mjcf/avatar.
struct HandShape {
  double finger_half_width_m = 0.009;  ///< across the closing direction
  double finger_thickness_m = 0.005;   ///< along it
  double finger_tip_m = 0.02;          ///< how far the fingers reach beyond the point between the pads
  double palm_front_m = 0.1, palm_back_m = 0.14;
  double palm_half_length_m = 0.062;  ///< along the closing direction
  double palm_half_width_m = 0.022;
  double forearm_half_width_m = 0.034;
  double widest_opening_m = 0.058;  ///< of one finger, from the middle
};

/// How the hand is turned: a level closing direction has `yaw` in W; from pointing straight down the fingers are tilted
/// by `tilt` about it, and the hand is rolled by `roll` about them. For a hand as it is natural, a positive tilt brings
/// the wrist nearer to the avatar.
struct HandTurn {
  double yaw = 0, tilt = 0, roll = 0;
};

Eigen::Quaterniond rotation(const HandTurn& turn);

/// The turn of the hand; without roll where the closing direction is about level.
HandTurn turn_of(const Eigen::Quaterniond& R_WT);

/// Whether the closing direction is about level, so that the hand comes and goes from and to above.
bool is_level(const Eigen::Quaterniond& R_WT);

/// Yaw of the closing direction at `p_W` when the last hinge is at zero and the fingers point down.
double natural_yaw(const Vec3& p_W, const Vec3& base_W);

/// How deep a hand at `X_WT` that is open by `opening_m` would be in the deepest of `others`; 0: there is room.
double hand_conflict(const Pose& X_WT, double opening_m, const std::vector<OrientedBox>& others);

/// How deep a forearm between those two points would be in the deepest of `others`; 0: there is room.
double forearm_conflict(const Vec3& elbow_W, const Vec3& wrist_W, const std::vector<OrientedBox>& others);

}  // namespace continua
