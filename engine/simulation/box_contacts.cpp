#include "continua/simulation/box_contacts.h"

#include <algorithm>
#include <array>

#include "continua/simulation/mujoco_api.h"
#include "continua/simulation/oriented_box.h"

namespace continua {

namespace {

mjfCollision unguarded = nullptr;

constexpr mjtNum slack_m = 1e-4;

OrientedBox box_of_geom(const mjModel* model, const mjData* data, int geom) {
  using RowMajor = Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>;
  return {Eigen::Map<const Vec3>(data->geom_xpos + 3 * geom), Eigen::Map<const RowMajor>(data->geom_xmat + 9 * geom),
          Eigen::Map<const Vec3>(model->geom_size + 3 * geom)};
}

/// Puts the contacts of two flush faces in the place of a contact of two edges, and returns their number; 1 where the
/// faces are not flush. Boxes that are pressed together have contacts of faces, and all depths grow by the same.
int faces_for_edge(const mjModel* model, mujoco::CollisionData* data, mujoco::FoundContact* contacts, int geom1,
                   int geom2, mjtNum margin) {
  constexpr mjtNum press_m = 1e-3, same_way = 0.99;
  const Vec3 normal_W = Eigen::Map<const Vec3>(mujoco::normal_of(contacts[0]));
  Eigen::Map<Vec3> center_W(data->geom_xpos + 3 * geom2);
  const Vec3 before_W = center_W;
  center_W -= press_m * normal_W;
  std::array<mujoco::FoundContact, mjMAXCONPAIR> pressed;
  const int found = unguarded(model, data, pressed.data(), geom1, geom2, margin);
  center_W = before_W;
  int kept = 0;
  for (int i = 0; i < found; ++i) {
    mujoco::FoundContact& contact = pressed[i];
    const mjtNum along = normal_W.dot(Eigen::Map<const Vec3>(mujoco::normal_of(contact)));
    contact.dist += press_m * along;
    if (along < same_way || contact.dist < contacts[0].dist - slack_m) return 1;
    Eigen::Map<Vec3>(contact.pos) += press_m / 2 * normal_W;
    if (contact.dist <= margin) pressed[kept++] = contact;
  }
  if (kept < 2) return 1;
  std::copy_n(pressed.begin(), kept, contacts);
  return kept;
}

int guarded(const mjModel* model, mujoco::CollisionData* data, mujoco::FoundContact* contacts, int geom1, int geom2,
            mjtNum margin) {
  int found = unguarded(model, data, contacts, geom1, geom2, margin);
  if (mujoco::edges_before_faces && found == 1) found = faces_for_edge(model, data, contacts, geom1, geom2, margin);
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
