// The avatar as what it takes up and how it can turn: its arm, the boxes of its links and its hand. Measured from the
// model, so that any arm does that follows mjcf/README.md.
#pragma once

#include <vector>

#include "continua/simulation/arm_ik.h"
#include "continua/simulation/oriented_box.h"

namespace continua {

/// The hand's measures, metres, from the point between the pads; `back` is along the fingers, toward the wrist.
struct HandShape {
  double finger_half_width_m = 0;  ///< across the closing direction
  double finger_thickness_m = 0;   ///< along it
  double finger_tip_m = 0;         ///< how far the fingers reach beyond the point between the pads
  double palm_front_m = 0, palm_back_m = 0;
  double palm_half_length_m = 0;  ///< along the closing direction
  double palm_half_width_m = 0;
  double widest_opening_m = 0;  ///< of one finger, from the middle
  double finger_N_per_m = 0;    ///< how hard a finger presses for each metre that it is told and cannot go
};

/// A part of the arm that can touch things, as a box in the frame after a hinge.
struct ArmPart {
  int hinge = 0;  ///< index
  Pose X_LP;      ///< of the box
  Vec3 half_m = Vec3::Zero();
};

struct AvatarForm {
  Arm arm;
  HandShape hand;
  std::vector<ArmPart> parts;
  double least_wrist = -2.9, most_wrist = 2.9;  ///< how far the hand can turn from natural about its fingers, radians

  /// Yaw of the closing direction that is natural for a hand at `p_W` whose fingers point down: across the line from
  /// the arm's base.
  double natural_yaw(const Vec3& p_W) const;
  bool wrist_turns(double from_natural) const { return from_natural > least_wrist && from_natural < most_wrist; }
};

/// How deep a hand at `X_WT` that is open by `opening_m` would be in the deepest of `others`; 0: there is room.
double hand_conflict(const HandShape& hand, const Pose& X_WT, double opening_m, const std::vector<OrientedBox>& others);

/// How deep the arm's parts would be in the deepest of `others`; 0: there is room.
double arm_conflict(const AvatarForm& avatar, const ArmVector& q, const std::vector<OrientedBox>& others);

}  // namespace continua
