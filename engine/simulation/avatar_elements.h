// The avatar in a MuJoCo model: ids of its hinges, fingers and weld, and its measures, by the rules of mjcf/README.md.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>

#include "continua/core/result.h"
#include "continua/simulation/avatar_form.h"

namespace continua {

/// A position servo for one value: a hinge's angle or the fingers' opening.
struct Servo {
  int actuator = -1;
  double at_zero = 0, per_unit = 1;
  double stiffness = 0;  ///< force on each joint for each unit between target and value
  double lead_s = 0;     ///< damping / stiffness: the lead of a moving target

  double control(double value) const { return at_zero + per_unit * value; }
};

/// A geom of a finger that stands in front of the pad, and would keep the pad from touching.
struct BeforePad {
  int geom = -1, pad = -1;
  double ahead_m = 0;  ///< nearer to the other finger than the pad
};

/// MuJoCo's ids.
struct AvatarElements {
  int hand = -1, weld = -1;
  std::vector<int> hand_bodies;  // the hand, its fingers and everything else on it
  std::vector<int> dof, qpos;    // one for each hinge
  std::vector<Servo> servo;      // one for each hinge
  std::array<int, 2> pad{};      // left, right
  std::vector<BeforePad> before_pads;
  std::vector<Servo> finger_servo;
};

/// The name of the site between the pads, and of the weld.
inline constexpr const char* grip_name = "grip";

/// MuJoCo's ids of the hinges from the world to the site `grip`, from the base outward; none without that site.
std::vector<int> arm_hinges(const mjModel& model);

/// The same, to a body.
std::vector<int> hinges_to(const mjModel& model, int body);

/// The body is the other one, or carried by it.
bool is_below(const mjModel& model, int body, int ancestor);

/// The geom can touch things.
bool is_solid(const mjModel& model, int geom);

/// Reads the chain of hinges from the world to the site `grip`, the fingers there and their measures. `qpos`: the arm
/// at home; `path`: the scene's. Errors name the missing element.
Result<std::pair<AvatarForm, AvatarElements>> find_avatar(const mjModel& model, const std::vector<double>& qpos,
                                                          const std::string& path);

inline Vec3 vec_of(const mjtNum* v) { return {v[0], v[1], v[2]}; }
inline Eigen::Quaterniond quat_of(const mjtNum* q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace continua
