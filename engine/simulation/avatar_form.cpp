#include "continua/simulation/avatar_form.h"

#include <algorithm>
#include <cmath>

namespace continua {

namespace {

double deepest(const OrientedBox& part, const std::vector<OrientedBox>& others) {
  double depth = 0;
  for (const auto& other : others) depth = std::max(depth, overlap_depth(part, other, depth));
  return depth;
}

}  // namespace

double AvatarForm::natural_yaw(const Vec3& p_W) const {
  const Vec3 base_W = arm.base_W();
  return std::atan2(p_W.x() - base_W.x(), base_W.y() - p_W.y());
}

double hand_conflict(const HandShape& hand, const Pose& X_WT, double opening_m,
                     const std::vector<OrientedBox>& others) {
  const Eigen::Matrix3d R_WT = X_WT.R_WB.toRotationMatrix();
  // In the hand's frame: x out of the palm, y the closing direction.
  const auto part = [&](double x_min, double x_max, double y, const Vec3& half) {
    return OrientedBox{X_WT.p_WB + R_WT * Vec3((x_min + x_max) / 2, y, 0), R_WT,
                       Vec3((x_max - x_min) / 2, half.y(), half.z())};
  };
  const Vec3 finger(0, hand.finger_thickness_m / 2, hand.finger_half_width_m);
  const double finger_y = opening_m + hand.finger_thickness_m / 2;
  const Vec3 palm(0, hand.palm_half_length_m, hand.palm_half_width_m);
  return std::max({deepest(part(-hand.palm_front_m, hand.finger_tip_m, finger_y, finger), others),
                   deepest(part(-hand.palm_front_m, hand.finger_tip_m, -finger_y, finger), others),
                   deepest(part(-hand.palm_back_m, -hand.palm_front_m, 0, palm), others)});
}

double arm_conflict(const AvatarForm& avatar, const ArmVector& q, const std::vector<OrientedBox>& others) {
  const auto links = link_poses(avatar.arm, q);
  double depth = 0;
  for (const auto& part : avatar.parts) {
    const Pose X_WP = links[static_cast<std::size_t>(part.hinge)] * part.X_LP;
    depth = std::max(depth, deepest({X_WP.p_WB, X_WP.R_WB.toRotationMatrix(), part.half_m}, others));
  }
  return depth;
}

}  // namespace continua
