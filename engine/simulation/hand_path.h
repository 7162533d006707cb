// Motions of the hand: a path through poses, its corners rounded, as a smooth motion of the arm's hinges.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "continua/simulation/arm_ik.h"

namespace continua {

/// How fast a motion may be.
struct Pace {
  double hand_m_per_s = 1.1;   ///< peak speed of the hand along its path
  double hinge_rad_per_s = 3;  ///< peak speed of any hinge
  double hinge_rad_per_s2 = 25;
};

/// Where the hinges shall be, and how fast they shall turn.
struct HingeTarget {
  ArmVector q;
  ArmVector qdot;
};

/// A motion from rest to rest, with a minimum-jerk profile along its path.
class HandPath {
 public:
  using Depth = std::function<double(const ArmVector&)>;

  /// Through `X_WT` in order, beginning at hinges `from`. Where the hinges cannot follow that, and it is more than one
  /// line: as far along the first line and as early along the last ones as they can, and by the hinges alone between.
  /// `depth` tells how deep the avatar would be in things: by the hinges alone it goes the way that is less deep,
  /// straight or by way of its home. Nothing if that cannot be done either.
  static std::optional<HandPath> plan(const Arm& arm, const ArmVector& from, const std::vector<Pose>& X_WT,
                                      const Pace& pace = {}, const Depth& depth = {});

  /// Straight from hinges to hinges, wherever the hand goes meanwhile.
  static HandPath between(const ArmVector& from, const ArmVector& to, const Pace& pace = {});

  /// Stays at `q`.
  static HandPath stay(const ArmVector& q);

  /// As plan, but never by the hinges alone.
  static std::optional<HandPath> plan_straight(const Arm& arm, const ArmVector& from, const std::vector<Pose>& X_WT,
                                               const Pace& pace);

  double duration_s() const { return duration_s_; }
  const ArmVector& end() const { return knots_.back(); }

  /// `t_s` is clamped to [0, duration_s].
  HingeTarget at(double t_s) const;

 private:
  static HandPath along(const Arm& arm, std::vector<ArmVector> knots, const Pace& pace);

  std::vector<ArmVector> knots_;
  std::vector<double> at_s_;  // where along the path each knot is: when, were it at full speed all the way
  double duration_s_ = 0;
};

}  // namespace continua
