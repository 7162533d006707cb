#include "continua/simulation/arm_ik.h"

#include "continua/core/random.h"
#include "continua/simulation/hand_path.h"
#include "continua/simulation/physics.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

Arm staircase_arm() {
  const auto scene = load_scene(source_dir() + "/mjcf/scenes/staircase.xml");
  REQUIRE(scene.ok());
  const auto physics = Physics::create(*scene);
  REQUIRE(physics.ok());
  return (*physics)->arm();
}

Pose fingers_down(const Vec3& p_WT, double yaw) {
  Eigen::Matrix3d R;
  const Vec3 x = -Vec3::UnitZ(), y(std::cos(yaw), std::sin(yaw), 0);
  R << x, y, x.cross(y);
  return {p_WT, Eigen::Quaterniond(R)};
}

bool within_limits(const Arm& arm, const ArmVector& q) {
  for (int i = 0; i < arm.size(); ++i) {
    if (q[i] < arm.joints[i].min || q[i] > arm.joints[i].max) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the arm reaches the whole table, from its surface to above a stack of six, within its limits") {
  const Arm arm = staircase_arm();
  double worst_m = 0;
  int reached = 0, tried = 0;
  for (double x = -0.49; x <= 0.495; x += 0.049)
    for (double y = -0.116; y <= 0.117; y += 0.029)
      for (const double z : {0.023, 0.1, 0.25, 0.45})
        for (const double yaw : {-1.57, 0.0, 1.57}) {
          const Pose wanted = fingers_down({x, y, z}, yaw);
          const IkSolution solution = solve_ik(arm, wanted, arm.home);
          ++tried;
          reached += solution.reached;
          worst_m = std::max(worst_m, (tool_pose(arm, solution.q).p_WB - wanted.p_WB).norm());
          REQUIRE(within_limits(arm, solution.q));
        }
  CHECK(reached == tried);
  CHECK(worst_m < 1e-3);
}

TEST_CASE("what is out of reach is told, and the limits are kept") {
  const Arm arm = staircase_arm();
  for (const Vec3& p : {Vec3(2, 0, 0.1), Vec3(0, 0, -3), Vec3(0, 0.45, 0.4)}) {
    const IkSolution solution = solve_ik(arm, fingers_down(p, 0), arm.home);
    CHECK_FALSE(solution.reached);
    CHECK(within_limits(arm, solution.q));
  }
}

TEST_CASE("no pose that a posture has is beyond the arm, and one that is a little longer away than the links are is") {
  const Arm arm = staircase_arm();
  Random random(11);
  double farthest_m = 0;
  for (int n = 0; n < 2000; ++n) {
    ArmVector q(arm.size());
    for (int i = 0; i < arm.size(); ++i)
      q[i] = arm.joints[i].min + random.uniform() * (arm.joints[i].max - arm.joints[i].min);
    const Pose X_WT = tool_pose(arm, q);
    REQUIRE_FALSE(is_beyond(arm, X_WT));
    farthest_m = std::max(farthest_m, (X_WT.p_WB - arm.base_W()).norm());
  }
  const Vec3 there = arm.base_W() + 1.3 * farthest_m * Vec3(0.6, -0.8, 0);
  CHECK(is_beyond(arm, fingers_down(there, 0)));
  CHECK_FALSE(find_ik(arm, fingers_down(there, 0)));
  CHECK_FALSE(is_beyond(arm, fingers_down({0.3, 0, 0.03}, 0)));
  CHECK(find_ik(arm, fingers_down({0.3, 0, 0.03}, 0)));
}

TEST_CASE("the jacobian is the derivative of the tool's pose") {
  const Arm arm = staircase_arm();
  Random random(7);
  for (int n = 0; n < 50; ++n) {
    ArmVector q(arm.size());
    for (int i = 0; i < arm.size(); ++i)
      q[i] = arm.joints[i].min + random.uniform() * (arm.joints[i].max - arm.joints[i].min);
    const auto J = tool_jacobian(arm, q);
    constexpr double h = 1e-6;
    for (int i = 0; i < arm.size(); ++i) {
      const ArmVector step = h * ArmVector::Unit(arm.size(), i);
      const Pose a = tool_pose(arm, q - step), b = tool_pose(arm, q + step);
      const Eigen::AngleAxisd turn(b.R_WB * a.R_WB.conjugate());
      CHECK((J.col(i).head<3>() - (b.p_WB - a.p_WB) / (2 * h)).norm() < 1e-6);
      CHECK((J.col(i).tail<3>() - turn.angle() * turn.axis() / (2 * h)).norm() < 1e-6);
    }
  }
}

TEST_CASE("a path starts and ends at rest, passes near its poses, and keeps its pace") {
  const Arm arm = staircase_arm();
  const Pose above = fingers_down({0.3, 0, 0.2}, 0), at = fingers_down({0.3, 0, 0.03}, 0);
  const Pace pace;
  const auto path = HandPath::plan(arm, arm.home, {above, at}, pace);
  REQUIRE(path);
  CHECK(path->at(0).q == arm.home);
  CHECK(path->at(0).qdot.norm() == Approx(0).margin(1e-9));
  CHECK((tool_pose(arm, path->end()).p_WB - at.p_WB).norm() < 1e-4);
  CHECK(path->at(path->duration_s() + 1).qdot.norm() == 0);

  constexpr double dt = 0.002;
  double nearest_m = 1, fastest = 0, fastest_hand = 0, worst_derivative = 0;
  for (double t = dt; t < path->duration_s(); t += dt) {
    const auto now = path->at(t);
    nearest_m = std::min(nearest_m, (tool_pose(arm, now.q).p_WB - above.p_WB).norm());
    fastest = std::max(fastest, now.qdot.cwiseAbs().maxCoeff());
    fastest_hand = std::max(fastest_hand, (tool_jacobian(arm, now.q).topRows<3>() * now.qdot).norm());
    const ArmVector change = (path->at(t + dt / 2).q - path->at(t - dt / 2).q) / dt;
    worst_derivative = std::max(worst_derivative, (change - now.qdot).cwiseAbs().maxCoeff());
  }
  CHECK(nearest_m < 0.06);
  CHECK(fastest < 1.1 * pace.hinge_rad_per_s);
  CHECK(fastest_hand < 1.1 * pace.hand_m_per_s);
  CHECK(worst_derivative < 0.02);
}

TEST_CASE("a path through what cannot be reached is none") {
  const Arm arm = staircase_arm();
  CHECK_FALSE(HandPath::plan(arm, arm.home, {fingers_down({1.5, 0, 0.2}, 0)}));
}
