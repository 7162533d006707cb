#include "simulation/hand_shape.h"

#include <algorithm>
#include <cmath>

namespace continua {

namespace {

double deepest(const OrientedBox& part, const std::vector<OrientedBox>& others) {
  double depth = 0;
  for (const auto& other : others) depth = std::max(depth, overlap_depth(part, other));
  return depth;
}

}  // namespace

Eigen::Quaterniond rotation(const HandTurn& turn) {
  Eigen::Matrix3d R;
  const Vec3 closing(std::cos(turn.yaw), std::sin(turn.yaw), 0), ahead(std::sin(turn.yaw), -std::cos(turn.yaw), 0);
  const Vec3 fingers = std::sin(turn.tilt) * ahead - std::cos(turn.tilt) * Vec3::UnitZ();
  R << fingers, closing, fingers.cross(closing);
  return Eigen::Quaterniond(R) * Eigen::AngleAxisd(turn.roll, Vec3::UnitX());
}

HandTurn turn_of(const Eigen::Quaterniond& R_WT) {
  const Vec3 fingers = R_WT * Vec3::UnitX(), closing = R_WT * Vec3::UnitY();
  if (is_level(R_WT)) {
    const Vec3 ahead(closing.y(), -closing.x(), 0);
    return {std::atan2(closing.y(), closing.x()), std::atan2(fingers.dot(ahead), -fingers.z())};
  }
  // Rolled, the fingers alone tell where ahead is.
  const double yaw = std::atan2(fingers.x(), -fingers.y());
  const Vec3 level(std::cos(yaw), std::sin(yaw), 0);
  return {yaw, std::atan2(fingers.head<2>().norm(), -fingers.z()),
          std::atan2(closing.dot(fingers.cross(level)), closing.dot(level))};
}

bool is_level(const Eigen::Quaterniond& R_WT) { return std::abs((R_WT * Vec3::UnitY()).z()) < 0.1; }

double natural_yaw(const Vec3& p_W, const Vec3& base_W) {
  return std::atan2(p_W.x() - base_W.x(), base_W.y() - p_W.y());
}

double hand_conflict(const Pose& X_WT, double opening_m, const std::vector<OrientedBox>& others) {
  const HandShape hand;
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

double forearm_conflict(const Vec3& elbow_W, const Vec3& wrist_W, const std::vector<OrientedBox>& others) {
  const double half = HandShape{}.forearm_half_width_m;
  const Vec3 along = wrist_W - elbow_W;
  const Eigen::Matrix3d R = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), along).toRotationMatrix();
  return deepest({(elbow_W + wrist_W) / 2, R, Vec3(along.norm() / 2, half, half)}, others);
}

}  // namespace continua
