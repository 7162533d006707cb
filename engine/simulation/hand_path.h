// Motions of the hand: paths through poses with rounded corners, as smooth motions of the arm's hinges.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "continua/simulation/arm_ik.h"

namespace continua {

/// Limits of a motion's speed.
struct Pace {
  double hand_m_per_s = 1.1;   ///< peak speed of the hand along its path
  double hinge_rad_per_s = 3;  ///< peak speed of any hinge
  double hinge_rad_per_s2 = 25;
};

/// Wanted angles and speeds of the hinges.
struct HingeTarget {
  ArmVector q;
  ArmVector qdot;
};

/// A motion from rest to rest, with a minimum-jerk profile along its path.
class HandPath {
 public:
  using Depth = std::function<double(const ArmVector&)>;

  /// A path from hinges `from` through `X_WT` in order. If the hinges cannot follow the lines, the path has the first
  /// line, as many of the last lines as possible, and a motion by the hinges alone between: straight or through the
  /// home posture, whichever is less deep in things by `depth`. Nothing if there is no such path either.
  static std::optional<HandPath> plan(const Arm& arm, const ArmVector& from, const std::vector<Pose>& X_WT,
                                      const Pace& pace = {}, const Depth& depth = {});

  /// Straight from hinges to hinges, wherever the hand goes meanwhile.
  static HandPath between(const ArmVector& from, const ArmVector& to, const Pace& pace = {});

  /// Stays at `q`.
  static HandPath stay(const ArmVector& q);

  /// Like plan, but never by the hinges alone.
  static std::optional<HandPath> plan_straight(const Arm& arm, const ArmVector& from, const std::vector<Pose>& X_WT,
                                               const Pace& pace);

  double duration_s() const { return duration_s_; }
  const ArmVector& end() const { return knots_.back(); }

  /// `t_s` is clamped to [0, duration_s].
  HingeTarget at(double t_s) const;

 private:
  static HandPath along(const Arm& arm, std::vector<ArmVector> knots, const Pace& pace);

  std::vector<ArmVector> knots_;
  std::vector<double> at_s_;  // time of each knot if the whole path were at full speed
  double duration_s_ = 0;
};

}  // namespace continua
