#include "continua/simulation/motion.h"

#include <algorithm>
#include <utility>

namespace continua {

namespace {

constexpr double finger_m_per_s = 0.15;

}  // namespace

Motion::Motion(const ArmVector& q, double opening_m)
    : wanted_opening_m(opening_m),
      path_(HandPath::stay(q)),
      leftover_qdot_(ArmVector::Zero(q.size())),
      behind_q_(leftover_qdot_),
      target_{{q, leftover_qdot_}, opening_m} {}

void Motion::follow(HandPath path) {
  follow_from_rest(std::move(path));
  leftover_qdot_ = target_.hinges.qdot;
}

void Motion::follow_from_rest(HandPath path) {
  path_ = std::move(path);
  path_s_ = 0;
  leftover_qdot_.setZero();
  behind_q_.setZero();
}

void Motion::stay() { follow_from_rest(HandPath::stay(target_.hinges.q)); }

void Motion::stay_at(const ArmVector& q) {
  target_.hinges.q = q;
  stay();
}

void Motion::brake() {
  const HingeTarget from = target_.hinges;
  // With a stop at this distance ahead, the cubic of advance() begins with the arm's speed.
  const ArmVector behind_q = from.qdot * fade_s / 3;
  follow_from_rest(HandPath::stay(from.q + behind_q));
  behind_q_ = behind_q;
}

const AvatarTarget& Motion::advance(double dt_s) {
  path_s_ += dt_s;
  target_.hinges = path_.at(path_s_);
  if (path_s_ < fade_s) {
    const double left = 1 - path_s_ / fade_s;
    target_.hinges.q += (leftover_qdot_ * path_s_ - behind_q_) * left * left * left;
    target_.hinges.qdot += leftover_qdot_ * left * left * (left - 3 * path_s_ / fade_s);
    target_.hinges.qdot += behind_q_ * 3 / fade_s * left * left;
  }
  const double step_m = finger_m_per_s * dt_s;
  target_.opening_m += std::clamp(wanted_opening_m - target_.opening_m, -step_m, step_m);
  return target_;
}

}  // namespace continua
