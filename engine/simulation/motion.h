// The avatar's motion: the arm along a path, the fingers to an opening. Neither jumps when a new motion begins.
#pragma once

#include "continua/simulation/hand_path.h"
#include "continua/simulation/physics.h"

namespace continua {

class Motion {
 public:
  /// The speed of a superseded motion, and a braking arm, fade out within this time.
  static constexpr double fade_s = 0.25;

  /// At rest at hinges `q`, the fingers open by `opening_m` each.
  Motion(const ArmVector& q, double opening_m);

  /// Follows `path`, which begins where the hinges are to be now; the present speed fades out.
  void follow(HandPath path);
  /// Follows `path` from rest.
  void follow_from_rest(HandPath path);
  /// Stays where the hinges are to be now.
  void stay();
  /// Stays at hinges `q`, from now on the place of the arm.
  void stay_at(const ArmVector& q);
  /// Comes to a stand along the way that the arm goes.
  void brake();

  /// One time step further. Returns the target of all servos in it.
  const AvatarTarget& advance(double dt_s);

  const AvatarTarget& target() const { return target_; }
  const ArmVector& end() const { return path_.end(); }
  /// The path has come to its end, or did so more than `ago_s` ago.
  bool is_over() const { return path_s_ >= path_.duration_s(); }
  bool is_over_since(double ago_s) const { return path_s_ > path_.duration_s() + ago_s; }

  double wanted_opening_m = 0;  ///< the fingers go there, each from the middle
  /// Opening of each finger at the grasp under way; the fingers let go by opening that far.
  double release_opening_m = 0;

 private:
  HandPath path_;
  double path_s_ = 0;        // time along the path
  ArmVector leftover_qdot_;  // speed of the motion before, which fades out
  ArmVector behind_q_;       // how far before its end a braking arm began
  AvatarTarget target_;
};

}  // namespace continua
