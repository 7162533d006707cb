#include "continua/world/geometry.h"

#include <cmath>

namespace continua {

Pose operator*(const Pose& X_AB, const Pose& X_BC) {
  return {X_AB.p_WB + X_AB.R_WB * X_BC.p_WB, X_AB.R_WB * X_BC.R_WB};
}

Pose inverse(const Pose& X_AB) {
  const Eigen::Quaterniond R_BA = X_AB.R_WB.conjugate();
  return {R_BA * -X_AB.p_WB, R_BA};
}

Vec3 depth_of(const Box& a, const Box& b) { return a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min); }

// Division of whole steps by the steps per metre gives the double nearest to the decimal; multiplication does not.
double on_grid(double length_m) {
  const double steps_per_m = std::round(1 / position_grid_m);
  return std::round(length_m * steps_per_m) / steps_per_m + 0.0;  // + 0.0 turns -0 into 0
}

Vec3 on_grid(const Vec3& p_W) { return {on_grid(p_W.x()), on_grid(p_W.y()), on_grid(p_W.z())}; }

double yaw_of(const Eigen::Quaterniond& R_WB) {
  const Eigen::Matrix3d R = R_WB.toRotationMatrix();
  return std::atan2(R(1, 0), R(0, 0));
}

}  // namespace continua
