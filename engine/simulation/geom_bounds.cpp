#include "continua/simulation/geom_bounds.h"

namespace continua {

namespace {

using Mat3 = Eigen::Matrix3d;

/// Half extents, along the body's axes, of a geom turned by R_BG about its own centre.
Vec3 half_extents(const mjModel& model, int geom, const Mat3& R_BG) {
  const Vec3 size = vec(model.geom_size + 3 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return Vec3::Constant(size[0]);
    case mjGEOM_CAPSULE:
      return R_BG.col(2).cwiseAbs() * size[1] + Vec3::Constant(size[0]);
    case mjGEOM_CYLINDER: {
      const Vec3 axis = R_BG.col(2);
      const Vec3 across = (Vec3::Ones() - axis.cwiseProduct(axis)).cwiseMax(0).cwiseSqrt();
      return axis.cwiseAbs() * size[1] + across * size[0];
    }
    case mjGEOM_ELLIPSOID:
      return (R_BG * size.asDiagonal()).rowwise().norm();
    default:
      return R_BG.cwiseAbs() * size;
  }
}

}  // namespace

Box body_bounds_B(const mjModel& model, int body) {
  Box bounds;
  bool first = true;
  const auto add = [&](const Vec3& low, const Vec3& high) {
    bounds.min = first ? low : bounds.min.cwiseMin(low).eval();
    bounds.max = first ? high : bounds.max.cwiseMax(high).eval();
    first = false;
  };

  for (int geom = model.body_geomadr[body]; geom < model.body_geomadr[body] + model.body_geomnum[body]; ++geom) {
    const mjtNum* q = model.geom_quat + 4 * geom;
    const Mat3 R_BG = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    const Vec3 p_BG = vec(model.geom_pos + 3 * geom);
    const int mesh = model.geom_type[geom] == mjGEOM_MESH ? model.geom_dataid[geom] : -1;
    if (mesh < 0) {
      const Vec3 half = half_extents(model, geom, R_BG);
      add(p_BG - half, p_BG + half);
      continue;
    }
    for (int i = model.mesh_vertadr[mesh]; i < model.mesh_vertadr[mesh] + model.mesh_vertnum[mesh]; ++i) {
      const float* v = model.mesh_vert + 3 * i;
      const Vec3 p_B = p_BG + R_BG * Vec3(v[0], v[1], v[2]);
      add(p_B, p_B);
    }
  }
  return bounds;
}

GeomBox geom_box_B(const mjModel& model, int geom) {
  const mjtNum* q = model.geom_quat + 4 * geom;
  return {{vec(model.geom_pos + 3 * geom), Eigen::Quaterniond(q[0], q[1], q[2], q[3])},
          half_extents(model, geom, Mat3::Identity())};
}

std::vector<Vec3> corners_A(const Pose& X_AG, const Vec3& half_m) {
  std::vector<Vec3> corners;
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-1, 1})
        corners.push_back(X_AG.p_WB + X_AG.R_WB * half_m.cwiseProduct(Vec3(x, y, z)).eval());
  return corners;
}

std::vector<Vec3> body_corners_B(const mjModel& model, int body) {
  std::vector<Vec3> corners;
  for (int geom = model.body_geomadr[body]; geom < model.body_geomadr[body] + model.body_geomnum[body]; ++geom) {
    if (model.geom_contype[geom] == 0 && model.geom_conaffinity[geom] == 0) continue;
    const GeomBox box = geom_box_B(model, geom);
    for (const Vec3& corner : corners_A(box.X_BG, box.half_m)) corners.push_back(corner);
  }
  return corners;
}

}  // namespace continua
