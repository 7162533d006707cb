// The avatar's motion: the arm along a path, the fingers to an opening, without a jump between motions.
#pragma once

#include "continua/simulation/hand_path.h"
#include "continua/simulation/physics.h"

namespace continua {

class Motion {
 public:
  /// The speed of a superseded motion fades out in this time; a braking arm stops in it.
  static constexpr double fade_s = 0.25;

  /// At rest at hinges `q`, the fingers open by `opening_m` each.
  Motion(const ArmVector& q, double opening_m);

  /// Follows `path`, which begins at the present target of the hinges; the present speed fades out.
  void follow(HandPath path);
  /// Follows `path` from rest.
  void follow_from_rest(HandPath path);
  /// Stays at the present target of the hinges.
  void stay();
  /// Stays at hinges `q`.
  void stay_at(const ArmVector& q);
  /// Brakes along the present direction of the arm.
  void brake();

  /// Advances by one time step. Returns the targets of all servos.
  const AvatarTarget& advance(double dt_s);

  const AvatarTarget& target() const { return target_; }
  const ArmVector& end() const { return path_.end(); }
  /// The path has ended; it ended more than `ago_s` ago.
  bool is_over() const { return path_s_ >= path_.duration_s(); }
  bool is_over_since(double ago_s) const { return path_s_ > path_.duration_s() + ago_s; }

  double wanted_opening_m = 0;  ///< goal of each finger, from the middle
  /// Opening of each finger at the grasp under way; the fingers let go by opening that far.
  double release_opening_m = 0;

 private:
  HandPath path_;
  double path_s_ = 0;        // time along the path
  ArmVector leftover_qdot_;  // speed of the previous motion, which fades out
  ArmVector behind_q_;       // way from the beginning to the end of braking
  AvatarTarget target_;
};

}  // namespace continua
