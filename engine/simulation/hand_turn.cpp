#include "continua/simulation/hand_turn.h"

#include <cmath>

namespace continua {

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
  // With a roll only the fingers show the direction ahead.
  const double yaw = std::atan2(fingers.x(), -fingers.y());
  const Vec3 level(std::cos(yaw), std::sin(yaw), 0);
  return {yaw, std::atan2(fingers.head<2>().norm(), -fingers.z()),
          std::atan2(closing.dot(fingers.cross(level)), closing.dot(level))};
}

bool is_level(const Eigen::Quaterniond& R_WT) {
  constexpr double level = 0.1;  // sine: 6 degrees, more than a grasp turns the hand
  return std::abs((R_WT * Vec3::UnitY()).z()) < level;
}

}  // namespace continua
