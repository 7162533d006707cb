// How the hand is turned.
#pragma once

#include "continua/world/geometry.h"

namespace continua {

/// A level closing direction has `yaw` in W; from pointing straight down the fingers are tilted by `tilt` about it, and
/// the hand is rolled by `roll` about them. For a hand as it is natural, a positive tilt brings the wrist nearer to the
/// avatar.
struct HandTurn {
  double yaw = 0, tilt = 0, roll = 0;
};

Eigen::Quaterniond rotation(const HandTurn& turn);

/// The turn of the hand; without roll where the closing direction is about level.
HandTurn turn_of(const Eigen::Quaterniond& R_WT);

/// Whether the closing direction is about level, so that the hand comes and goes from and to above.
bool is_level(const Eigen::Quaterniond& R_WT);

}  // namespace continua
