// The avatar's form: its arm, the boxes of its links and its hand. All measured from the model, so any arm by the rules
// of mjcf/README.md will do.
#pragma once

#include <vector>

#include "continua/simulation/arm_ik.h"
#include "continua/simulation/oriented_box.h"

namespace continua {

/// The hand's measures, metres, from the point between the pads; `back` is along the fingers, toward the wrist.
struct HandShape {
  double finger_half_width_m = 0;  ///< across the closing direction
  double finger_thickness_m = 0;   ///< along it
  double finger_tip_m = 0;         ///< length of the fingers beyond the point between the pads
  double palm_front_m = 0, palm_back_m = 0;
  double palm_half_length_m = 0;  ///< along the closing direction
  double palm_half_width_m = 0;
  double widest_opening_m = 0;  ///< of one finger, from the middle
  double finger_N_per_m = 0;    ///< force of a finger for each metre between target and opening
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
  double least_wrist = -2.9, most_wrist = 2.9;  ///< limits of the hand's turn about its fingers, from natural, radians

  /// Yaw of the closing direction that is natural for a hand at `p_W` whose fingers point down: across the line from
  /// the arm's base.
  double natural_yaw(const Vec3& p_W) const;
  bool wrist_turns(double from_natural) const { return from_natural > least_wrist && from_natural < most_wrist; }
};

/// Deepest overlap of a hand at `X_WT`, open by `opening_m`, with `others`; 0: there is room.
double hand_conflict(const HandShape& hand, const Pose& X_WT, double opening_m, const std::vector<OrientedBox>& others);

/// Deepest overlap of the arm's parts with `others`; 0: there is room.
double arm_conflict(const AvatarForm& avatar, const ArmVector& q, const std::vector<OrientedBox>& others);

}  // namespace continua
