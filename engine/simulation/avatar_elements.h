// Where the avatar's hinges, fingers and weld are in a model, and what it measures: the part of mjcf/README.md that
// concerns the avatar.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>

#include "continua/core/result.h"
#include "continua/simulation/avatar_form.h"

namespace continua {

/// What a position servo is told so that what it drives comes to be at a value (a hinge's angle, the fingers' opening).
struct Servo {
  int actuator = -1;
  double at_zero = 0, per_unit = 1;
  double stiffness = 0;  ///< force on each joint per unit that it is told and cannot go
  double lead_s = 0;     ///< damping / stiffness: how far ahead a moving target is put

  double control(double value) const { return at_zero + per_unit * value; }
};

/// MuJoCo's ids.
struct AvatarElements {
  int hand = -1, weld = -1;
  std::vector<int> hand_bodies;  // the hand, its fingers and all else on it
  std::vector<int> dof, qpos;    // of each hinge
  std::vector<Servo> servo;      // of each hinge
  std::array<int, 2> pad{};      // left, right
  std::vector<Servo> finger_servo;
};

/// The name of the site between the pads, and of the weld.
inline constexpr const char* grip_name = "grip";

/// The hinges from the world to the site `grip`, by MuJoCo's ids, from the base outward; none without that site.
std::vector<int> arm_hinges(const mjModel& model);

/// Reads the chain of hinges from the world to the site `grip`, the fingers there and what they measure; `qpos` is
/// where the arm is at home. Errors name what is missing; `path` is the scene's.
Result<std::pair<AvatarForm, AvatarElements>> find_avatar(const mjModel& model, const std::vector<double>& qpos,
                                                          const std::string& path);

inline Vec3 vec_of(const mjtNum* v) { return {v[0], v[1], v[2]}; }
inline Eigen::Quaterniond quat_of(const mjtNum* q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace continua
