#include "continua/simulation/box_contacts.h"

#include "continua/simulation/mujoco_api.h"
#include "continua/simulation/oriented_box.h"

namespace continua {

namespace {

mjfCollision unguarded = nullptr;

OrientedBox box_of_geom(const mjModel* model, const mjData* data, int geom) {
  using RowMajor = Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>;
  return {Eigen::Map<const Vec3>(data->geom_xpos + 3 * geom), Eigen::Map<const RowMajor>(data->geom_xmat + 9 * geom),
          Eigen::Map<const Vec3>(model->geom_size + 3 * geom)};
}

int guarded(const mjModel* model, mujoco::CollisionData* data, mujoco::FoundContact* contacts, int geom1, int geom2,
            mjtNum margin) {
  constexpr mjtNum slack_m = 1e-4;
  const int found = unguarded(model, data, contacts, geom1, geom2, margin);
  if (found == 0) return 0;
  const mjtNum deepest = overlap_depth(box_of_geom(model, data, geom1), box_of_geom(model, data, geom2)) + slack_m;
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
