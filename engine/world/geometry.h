// Points, boxes and poses. The only place where Eigen is included outside inverse kinematics.
// Frame W: metres, z up, origin at the centre of the table's surface, x to the human's right, y away from
// the human (toward the avatar). p_WQ is the position of Q from W's origin, expressed in W; R_WB a rotation.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace continua {

using Vec3 = Eigen::Vector3d;

/// Position and orientation of a body in the world.
struct Pose {
  Vec3 p_WB = Vec3::Zero();
  Eigen::Quaterniond R_WB = Eigen::Quaterniond::Identity();
};

/// The pose of C in A, from that of B in A and that of C in B.
Pose operator*(const Pose& X_AB, const Pose& X_BC);
/// The pose of A in B.
Pose inverse(const Pose& X_AB);

/// An axis-aligned box of the world, metres. A region on the table is a box without height.
struct Box {
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();

  Vec3 center() const { return (min + max) / 2; }
};

/// How far two boxes reach into each other along each axis; below 0 it is the gap between them.
Vec3 depth_of(const Box& a, const Box& b);

/// The grid on which decisions see the world: positions are rounded to a tenth of a millimetre, so that the
/// noise of floating point on another machine does not reach a decision.
inline constexpr double position_grid_m = 1e-4;

/// `length_m` rounded to `position_grid_m`.
double on_grid(double length_m);
Vec3 on_grid(const Vec3& p_W);

/// Yaw (rotation about z) of an orientation, radians in (-pi, pi].
double yaw_of(const Eigen::Quaterniond& R_WB);

}  // namespace continua
