#include "continua/simulation/arm_ik.h"

#include <array>

#include <Eigen/Cholesky>

namespace continua {

namespace {

using Twist = Eigen::Matrix<double, 6, 1>;

/// Frames after each hinge, and the tool's.
struct Chain {
  std::array<Pose, most_arm_joints> links;
  Pose tool;
};

Chain chain_of(const Arm& arm, const ArmVector& q) {
  Chain chain;
  Pose X_W;
  for (int i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints[i];
    X_W = X_W * joint.X_PJ * Pose{Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(q[i], joint.axis_J))};
    chain.links[i] = X_W;
  }
  chain.tool = X_W * arm.X_LT;
  return chain;
}

ArmJacobian jacobian_of(const Arm& arm, const Chain& chain) {
  ArmJacobian J(6, arm.size());
  for (int i = 0; i < arm.size(); ++i) {
    const Vec3 axis_W = chain.links[i].R_WB * arm.joints[i].axis_J;
    J.col(i) << axis_W.cross(chain.tool.p_WB - chain.links[i].p_WB), axis_W;
  }
  return J;
}

/// The displacement and the rotation vector from `from` to `to`, in W.
Twist difference(const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd turn(to.R_WB * from.R_WB.conjugate());
  Twist twist;
  twist << to.p_WB - from.p_WB, turn.angle() * turn.axis();
  return twist;
}

/// Postures spread over the limits, away from their ends: the Halton sequence.
ArmVector spread_posture(const Arm& arm, int n) {
  constexpr std::array<int, most_arm_joints> primes = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  constexpr double margin = 0.15;  // of the range, at either end
  ArmVector q(arm.size());
  for (int i = 0; i < arm.size(); ++i) {
    double fraction = 0, digit = 1;
    for (int rest = n; rest > 0; rest /= primes[i]) {
      digit /= primes[i];
      fraction += digit * (rest % primes[i]);
    }
    const ArmJoint& joint = arm.joints[i];
    q[i] = joint.min + (joint.max - joint.min) * (margin + (1 - 2 * margin) * fraction);
  }
  return q;
}

}  // namespace

std::vector<Pose> link_poses(const Arm& arm, const ArmVector& q) {
  const Chain chain = chain_of(arm, q);
  return {chain.links.begin(), chain.links.begin() + arm.size()};
}

Pose tool_pose(const Arm& arm, const ArmVector& q) { return chain_of(arm, q).tool; }

ArmJacobian tool_jacobian(const Arm& arm, const ArmVector& q) { return jacobian_of(arm, chain_of(arm, q)); }

IkSolution solve_ik(const Arm& arm, const Pose& X_WT, const ArmVector& seed) {
  constexpr int max_iterations = 200;
  constexpr double damping = 0.01;       // of the least squares: a larger one is slower, but calmer near singularities
  constexpr double posture_gain = 0.1;   // part of the way home in the first iteration, in the free directions
  constexpr double posture_decay = 0.8;  // per iteration: damping lets a little of the posture disturb the tool
  constexpr double largest_step_rad = 0.3;  // of any hinge in one iteration
  constexpr double good_enough = 0.01;      // of the tolerances: iterate on, it costs little
  constexpr int patience = 30;              // iterations without progress: the solution is stuck
  constexpr double nearer = 0.99;           // less than this part of the error before is progress

  IkSolution solution;
  solution.q = seed;
  double posture = posture_gain, least_error = 0;
  int nearest_at = 0;
  for (int iteration = 0;; ++iteration, posture *= posture_decay) {
    const Chain chain = chain_of(arm, solution.q);
    const Twist error = difference(chain.tool, X_WT);
    solution.position_error_m = error.head<3>().norm();
    solution.rotation_error = error.tail<3>().norm();
    solution.reached = solution.position_error_m < ik_tolerance_m && solution.rotation_error < ik_tolerance_rad;
    const bool good = solution.position_error_m < good_enough * ik_tolerance_m &&
                      solution.rotation_error < good_enough * ik_tolerance_rad;
    if (iteration == 0 || error.norm() < nearer * least_error) {
      least_error = error.norm();
      nearest_at = iteration;
    }
    if (good || iteration == max_iterations || iteration - nearest_at > patience) return solution;

    const ArmJacobian J = jacobian_of(arm, chain);
    const Eigen::Matrix<double, 6, 6> JJt = J * J.transpose();
    const auto damped = (JJt + damping * damping * Eigen::Matrix<double, 6, 6>::Identity()).eval().ldlt();
    const ArmVector toward = J.transpose() * damped.solve(error);
    const ArmVector home = posture * (arm.home - solution.q);
    // The part of `home` that does not move the tool.
    const ArmVector free = home - J.transpose() * damped.solve(J * home);
    ArmVector step = toward + free;
    const double largest = step.cwiseAbs().maxCoeff();
    if (largest > largest_step_rad) step *= largest_step_rad / largest;
    solution.q += step;
    for (int i = 0; i < arm.size(); ++i)
      solution.q[i] = std::min(std::max(solution.q[i], arm.joints[i].min), arm.joints[i].max);
  }
}

bool is_beyond(const Arm& arm, const Pose& X_WT) {
  // A hinge does not move the next one's origin that lies on its axis, nor the last hinge the one before.
  const auto on_axis = [](const ArmJoint& joint, const Vec3& p_J) { return joint.axis_J.cross(p_J).norm() < 1e-9; };
  int first = 0, last = arm.size() - 1;
  Pose X_WF = arm.joints[first].X_PJ;
  if (first < last && on_axis(arm.joints[first], arm.joints[first + 1].X_PJ.p_WB))
    X_WF = X_WF * arm.joints[++first].X_PJ;
  Pose X_WL = X_WT * inverse(arm.X_LT);
  const Pose back = inverse(arm.joints[last].X_PJ);
  if (first < last && on_axis(arm.joints[last], back.p_WB)) X_WL = X_WL * back, --last;
  double length_m = ik_tolerance_m;
  for (int i = first + 1; i <= last; ++i) length_m += arm.joints[i].X_PJ.p_WB.norm();
  return (X_WL.p_WB - X_WF.p_WB).norm() > length_m;
}

std::optional<ArmVector> find_ik(const Arm& arm, const Pose& X_WT) {
  constexpr int postures = 8;
  if (is_beyond(arm, X_WT)) return std::nullopt;
  for (int n = 0; n <= postures; ++n)
    if (auto solution = solve_ik(arm, X_WT, n == 0 ? arm.home : spread_posture(arm, n)); solution.reached)
      return solution.q;
  return std::nullopt;
}

}  // namespace continua
