// Inverse kinematics of the avatar's arm: hinges in a chain, the last of which carries the tool frame T (the point
// between the finger pads; x out of the palm, y the way the fingers close).
#pragma once

#include <optional>
#include <vector>

#include "continua/world/geometry.h"

namespace continua {

inline constexpr int most_arm_joints = 12;
/// One number per hinge: radians, or radians per second.
using ArmVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_arm_joints, 1>;
/// Change of a pose with each hinge: rows 0–2 velocity of the origin, rows 3–5 angular velocity (6 x hinges).
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, most_arm_joints>;

struct ArmJoint {
  Pose X_PJ;                    ///< the hinge at zero, in the frame after the previous hinge (first: in W)
  Vec3 axis_J = Vec3::UnitZ();  ///< unit vector through the frame's origin
  double min = 0, max = 0;      ///< radians
};

struct Arm {
  std::vector<ArmJoint> joints;  ///< from the base outward, at most most_arm_joints
  Pose X_LT;                     ///< of the tool, in the frame after the last hinge
  ArmVector home;                ///< preferred posture

  int size() const { return static_cast<int>(joints.size()); }
  Vec3 base_W() const { return joints.front().X_PJ.p_WB; }
};

/// Frames after each hinge, in W.
std::vector<Pose> link_poses(const Arm& arm, const ArmVector& q);

/// Pose of the tool in W.
Pose tool_pose(const Arm& arm, const ArmVector& q);

/// Jacobian of the tool's pose, in W.
ArmJacobian tool_jacobian(const Arm& arm, const ArmVector& q);

struct IkSolution {
  ArmVector q;  ///< within the limits, reached or not
  double position_error_m = 0;
  double rotation_error = 0;  ///< radians
  bool reached = false;       ///< both errors are below the tolerances of ik_tolerance_m and ik_tolerance_rad
};

inline constexpr double ik_tolerance_m = 1e-4;
inline constexpr double ik_tolerance_rad = 1e-3;

/// Damped least squares from `seed` to the tool pose `X_WT`, with the home posture as a second goal in free directions.
/// The solution stays on the arm's branch of `seed`, as motions need it.
IkSolution solve_ik(const Arm& arm, const Pose& X_WT, const ArmVector& seed);

/// Whether the pose asks for two hinges of the arm to be farther apart than the links between them are long, so that no
/// posture reaches it.
bool is_beyond(const Arm& arm, const Pose& X_WT);

/// A posture that reaches the pose: by solve_ik from the home posture, else from postures spread over the limits.
/// Nothing if none of them leads there, or at once where the pose is_beyond the arm.
std::optional<ArmVector> find_ik(const Arm& arm, const Pose& X_WT);

}  // namespace continua
