#include "world/world_snapshot.h"

#include <cmath>

namespace continua {

namespace {

/// The axis-aligned box around one that is turned about z.
Box box_around(const Vec3& center_W, const Vec3& half_extents_m, double yaw) {
  const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
  const Vec3 half(c * half_extents_m.x() + s * half_extents_m.y(), s * half_extents_m.x() + c * half_extents_m.y(),
                  half_extents_m.z());
  return {on_grid(Vec3(center_W - half)), on_grid(Vec3(center_W + half))};
}

}  // namespace

Box ObjectState::bounds_W() const { return box_around(p_WO, half_extents_m, yaw); }

std::optional<Box> ObjectState::interior_W() const {
  if (!interior) return std::nullopt;
  const Vec3 center_W = p_WO + Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * interior->center();
  return box_around(center_W, (interior->max - interior->min) / 2, yaw);
}

const ObjectState* WorldSnapshot::find(std::string_view name) const {
  for (const auto& object : objects)
    if (object.name == name) return &object;
  return nullptr;
}

}  // namespace continua
