#include "continua/simulation/oriented_box.h"

#include <algorithm>

namespace continua {

double overlap_depth(const OrientedBox& a, const OrientedBox& b, double enough_m) {
  const Vec3 apart = b.center_W - a.center_W;
  double least = std::numeric_limits<double>::max();
  for (const OrientedBox* faces : {&a, &b}) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 axis = faces->R_WB.col(i);
      const double reach =
          (a.R_WB.transpose() * axis).cwiseAbs().dot(a.half_m) + (b.R_WB.transpose() * axis).cwiseAbs().dot(b.half_m);
      least = std::min(least, reach - std::abs(axis.dot(apart)));
      if (least <= enough_m) return least;
    }
  }
  return least;
}

namespace {

constexpr double far_down_m = 0.5;  // deeper than a hand ever reaches

}  // namespace

OrientedBox box_of(const ObjectState& object) {
  return {object.p_WO, Eigen::AngleAxisd(object.yaw, Vec3::UnitZ()).toRotationMatrix(), object.half_extents_m};
}

OrientedBox column_of(const ObjectState& object) {
  OrientedBox column = box_of(object);
  column.center_W.z() -= far_down_m;
  column.half_m.z() += far_down_m;
  return column;
}

OrientedBox table_block(const Box& table) {
  const Vec3 below(0, 0, far_down_m);
  return {table.center() - below, Eigen::Matrix3d::Identity(), (table.max - table.min) / 2 + below};
}

}  // namespace continua
