#include "simulation/box_contacts.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace continua {

namespace {

using Mat3 = Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>;
using Vec = Eigen::Matrix<mjtNum, 3, 1>;

mjfCollision unguarded = nullptr;

/// How deep two boxes overlap: the least way along which one would have to be moved to part them (separating axes).
mjtNum overlap(const mjModel* model, const mjData* data, int geom1, int geom2) {
  const Mat3 R1 = Eigen::Map<const Mat3>(data->geom_xmat + 9 * geom1);
  const Mat3 R2 = Eigen::Map<const Mat3>(data->geom_xmat + 9 * geom2);
  const Vec half1 = Eigen::Map<const Vec>(model->geom_size + 3 * geom1);
  const Vec half2 = Eigen::Map<const Vec>(model->geom_size + 3 * geom2);
  const Vec apart =
      Eigen::Map<const Vec>(data->geom_xpos + 3 * geom2) - Eigen::Map<const Vec>(data->geom_xpos + 3 * geom1);
  mjtNum least = mjMAXVAL;
  const auto try_axis = [&](const Vec& axis) {
    const mjtNum reach = (R1.transpose() * axis).cwiseAbs().dot(half1) + (R2.transpose() * axis).cwiseAbs().dot(half2);
    least = std::min(least, reach - std::abs(axis.dot(apart)));
  };
  // The faces' axes suffice: those of pairs of edges could only make the overlap smaller.
  for (int i = 0; i < 3; ++i) {
    try_axis(R1.col(i));
    try_axis(R2.col(i));
  }
  return least;
}

int guarded(const mjModel* model, const mjData* data, mjContact* contacts, int geom1, int geom2, mjtNum margin) {
  constexpr mjtNum slack_m = 1e-4;
  const int found = unguarded(model, data, contacts, geom1, geom2, margin);
  if (found == 0) return 0;
  const mjtNum deepest = overlap(model, data, geom1, geom2) + slack_m;
  int kept = 0;
  for (int i = 0; i < found; ++i) {
    if (-contacts[i].dist <= deepest) contacts[kept++] = contacts[i];
  }
  return kept;
}

}  // namespace

void guard_box_contacts() {
  static const bool once = [] {
    unguarded = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX];
    mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX] = guarded;
    return true;
  }();
  static_cast<void>(once);
}

}  // namespace continua
