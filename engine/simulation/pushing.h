// Pushes along the table: the hand comes down behind an object, open so that both finger tips meet its face, and moves
// on.
#pragma once

#include <string>

#include "continua/body/reason.h"
#include "continua/simulation/handling.h"

namespace continua {

/// One straight push.
struct Push {
  Pose behind_X_WT;              ///< the hand's first pose, a little behind the object
  Pose end_X_WT;                 ///< the hand's last pose, with the object at the end of the push
  Vec3 ahead_W = Vec3::UnitX();  ///< unit vector of the push
  double opening_m = 0;          ///< of each finger
};

/// A pushed object this near to its goal is left alone. Half of the largest error of one push.
inline constexpr double pushed_m = 0.004;

/// The next push that brings the object's centre nearer to `p_WG`, or the reason why there is none. A round thing is
/// pushed straight toward the goal, others along their own axes, since a push across a face does not turn them. The
/// object may touch `landmark`. REQUIRES that the object
/// is farther than pushed_m from the goal along one of the axes.
OrReason<Push> plan_push(const ObjectState& object, const Vec3& p_WG, const std::string& landmark,
                         const WorldSnapshot& world, const Means& means);

/// The object is not near enough to its goal yet.
bool needs_push(const ObjectState& object, const Vec3& p_WG, const Means& means);

}  // namespace continua
