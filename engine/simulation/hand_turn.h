// The orientation of the hand.
#pragma once

#include "continua/world/geometry.h"

namespace continua {

/// Three turns, radians. The closing direction is level and has `yaw` in W; the fingers are tilted by `tilt` about that
/// direction, from straight down; the hand is rolled by `roll` about the fingers. A positive tilt of a hand in its
/// natural turn brings the wrist nearer to the avatar.
struct HandTurn {
  double yaw = 0, tilt = 0, roll = 0;
};

Eigen::Quaterniond rotation(const HandTurn& turn);

/// The turn of a hand; without roll if the closing direction is about level.
HandTurn turn_of(const Eigen::Quaterniond& R_WT);

/// The closing direction is about level, so the hand comes from above and goes there.
bool is_level(const Eigen::Quaterniond& R_WT);

}  // namespace continua
