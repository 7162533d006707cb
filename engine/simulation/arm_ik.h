// Inverse kinematics of the avatar's arm: seven hinges in a chain, the last of which carries the tool frame T (the
// point between the finger pads; x out of the palm, y the way the fingers close).
#pragma once

#include <array>

#include "world/geometry.h"

namespace continua {

inline constexpr int arm_joint_count = 7;
using ArmVector = Eigen::Matrix<double, arm_joint_count, 1>;  ///< one number per hinge: radians, or radians per second

struct ArmJoint {
  Pose X_PJ;                    ///< of the hinge at zero, in the frame after the hinge before it (the first: in W)
  Vec3 axis_J = Vec3::UnitZ();  ///< unit vector
  double min = 0, max = 0;      ///< radians
};

struct Arm {
  std::array<ArmJoint, arm_joint_count> joints;
  Pose X_LT;                           ///< of the tool, in the frame after the last hinge
  ArmVector home = ArmVector::Zero();  ///< preferred posture
};

/// Frames after each hinge, in W.
std::array<Pose, arm_joint_count> link_poses(const Arm& arm, const ArmVector& q);

/// Pose of the tool in W.
Pose tool_pose(const Arm& arm, const ArmVector& q);

/// How the tool's pose changes with each hinge: rows 0–2 velocity of its origin, 3–5 angular velocity, in W (6 x 7).
Eigen::Matrix<double, 6, arm_joint_count> tool_jacobian(const Arm& arm, const ArmVector& q);

struct IkSolution {
  ArmVector q = ArmVector::Zero();  ///< within the limits, reached or not
  double position_error_m = 0;
  double rotation_error = 0;  ///< radians
  bool reached = false;       ///< both errors are below the tolerances of ik_tolerance_m and ik_tolerance_rad
};

inline constexpr double ik_tolerance_m = 1e-4;
inline constexpr double ik_tolerance_rad = 1e-3;

/// Damped least squares from `seed` toward the tool pose `X_WT`; in the one direction the task leaves free, toward the
/// home posture.
IkSolution solve_ik(const Arm& arm, const Pose& X_WT, const ArmVector& seed);

}  // namespace continua
