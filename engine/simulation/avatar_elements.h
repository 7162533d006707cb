// Where the avatar's hinges, fingers and weld are in a model: the part of mjcf/README.md that concerns the avatar.
#pragma once

#include <array>
#include <string>
#include <utility>

#include <mujoco/mujoco.h>

#include "core/result.h"
#include "simulation/arm_ik.h"

namespace continua {

/// MuJoCo's ids.
struct AvatarElements {
  int hand = -1, weld = -1;
  std::array<int, arm_joint_count> dof{}, qpos{}, servo{};
  std::array<int, 2> pad{}, finger_servo{};      // left, right
  std::array<double, arm_joint_count> lead_s{};  // servo damping / stiffness: how far ahead a moving target is put
};

/// Reads the chain of hinges from the world to the site `grip`. Errors name what is missing; `path` is the scene's.
Result<std::pair<Arm, AvatarElements>> find_avatar(const mjModel& model, const std::string& path);

inline Vec3 vec_of(const mjtNum* v) { return {v[0], v[1], v[2]}; }
inline Eigen::Quaterniond quat_of(const mjtNum* q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace continua
