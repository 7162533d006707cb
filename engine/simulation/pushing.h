// Moving an object along the table by contact: the hand comes down behind it, open so far that both finger tips meet
// its face, and moves on.
#pragma once

#include <string>

#include "continua/body/reason.h"
#include "continua/simulation/handling.h"

namespace continua {

/// One straight way of the hand with the object before it.
struct Push {
  Pose behind_X_WT;              ///< where the hand comes down, a little behind the object
  Pose end_X_WT;                 ///< where it is when the object is as far as it shall be in that direction
  Vec3 ahead_W = Vec3::UnitX();  ///< unit vector along which it pushes
  double opening_m = 0;          ///< of each finger
};

/// How near to its goal a pushed object is left alone. Half of what the error of one push is at most.
inline constexpr double pushed_m = 0.004;

/// The next push that brings the object's centre nearer to `p_WG`: of a round thing straight toward it, of others along
/// their own axes, for a push across a face does not turn them. It may touch `landmark`. REQUIRES that the object
/// is farther than pushed_m from the goal along one of the axes.
OrReason<Push> plan_push(const ObjectState& object, const Vec3& p_WG, const std::string& landmark,
                         const WorldSnapshot& world, const Means& means);

/// Whether an object is to be pushed farther.
bool needs_push(const ObjectState& object, const Vec3& p_WG, const Means& means);

}  // namespace continua
