#include "simulation/arm_ik.h"

#include <Eigen/Cholesky>

namespace continua {

namespace {

using Jacobian = Eigen::Matrix<double, 6, arm_joint_count>;
using Twist = Eigen::Matrix<double, 6, 1>;

Pose operator*(const Pose& a, const Pose& b) { return {a.p_WB + a.R_WB * b.p_WB, a.R_WB * b.R_WB}; }

/// Frames after each hinge, and the tool's.
struct Chain {
  std::array<Pose, arm_joint_count> links;
  Pose tool;
};

Chain chain_of(const Arm& arm, const ArmVector& q) {
  Chain chain;
  Pose X_W;
  for (int i = 0; i < arm_joint_count; ++i) {
    const ArmJoint& joint = arm.joints[i];
    X_W = X_W * joint.X_PJ * Pose{Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(q[i], joint.axis_J))};
    chain.links[i] = X_W;
  }
  chain.tool = X_W * arm.X_LT;
  return chain;
}

Jacobian jacobian_of(const Arm& arm, const Chain& chain) {
  Jacobian J;
  for (int i = 0; i < arm_joint_count; ++i) {
    const Vec3 axis_W = chain.links[i].R_WB * arm.joints[i].axis_J;
    J.col(i) << axis_W.cross(chain.tool.p_WB - chain.links[i].p_WB), axis_W;
  }
  return J;
}

/// What takes the tool from `from` to `to`: a displacement and a rotation vector, in W.
Twist difference(const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd turn(to.R_WB * from.R_WB.conjugate());
  Twist twist;
  twist << to.p_WB - from.p_WB, turn.angle() * turn.axis();
  return twist;
}

}  // namespace

std::array<Pose, arm_joint_count> link_poses(const Arm& arm, const ArmVector& q) { return chain_of(arm, q).links; }

Pose tool_pose(const Arm& arm, const ArmVector& q) { return chain_of(arm, q).tool; }

Jacobian tool_jacobian(const Arm& arm, const ArmVector& q) { return jacobian_of(arm, chain_of(arm, q)); }

IkSolution solve_ik(const Arm& arm, const Pose& X_WT, const ArmVector& seed) {
  constexpr int max_iterations = 200;
  constexpr double damping = 0.01;          // of the least squares: larger is slower but calmer near singularities
  constexpr double posture_gain = 0.1;      // of the way home in the first iteration, in the free direction
  constexpr double posture_decay = 0.8;     // per iteration: damping lets a little of the posture disturb the tool
  constexpr double largest_step_rad = 0.3;  // of any hinge in one iteration
  constexpr double good_enough = 0.01;      // of the tolerances: iterate on, it costs little

  IkSolution solution;
  solution.q = seed;
  double posture = posture_gain;
  for (int iteration = 0;; ++iteration, posture *= posture_decay) {
    const Chain chain = chain_of(arm, solution.q);
    const Twist error = difference(chain.tool, X_WT);
    solution.position_error_m = error.head<3>().norm();
    solution.rotation_error = error.tail<3>().norm();
    solution.reached = solution.position_error_m < ik_tolerance_m && solution.rotation_error < ik_tolerance_rad;
    const bool good = solution.position_error_m < good_enough * ik_tolerance_m &&
                      solution.rotation_error < good_enough * ik_tolerance_rad;
    if (good || iteration == max_iterations) return solution;

    const Jacobian J = jacobian_of(arm, chain);
    const Eigen::Matrix<double, 6, 6> JJt = J * J.transpose();
    const auto damped = (JJt + damping * damping * Eigen::Matrix<double, 6, 6>::Identity()).eval().ldlt();
    const ArmVector toward = J.transpose() * damped.solve(error);
    const ArmVector home = posture * (arm.home - solution.q);
    // The part of `home` that leaves the tool where it is.
    const ArmVector free = home - J.transpose() * damped.solve(J * home);
    ArmVector step = toward + free;
    const double largest = step.cwiseAbs().maxCoeff();
    if (largest > largest_step_rad) step *= largest_step_rad / largest;
    solution.q += step;
    for (int i = 0; i < arm_joint_count; ++i)
      solution.q[i] = std::min(std::max(solution.q[i], arm.joints[i].min), arm.joints[i].max);
  }
}

}  // namespace continua
