#include "continua/world/world_snapshot.h"

#include <algorithm>
#include <cmath>

namespace continua {

Box ObjectState::bounds_W() const {
  const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
  const Vec3 half(c * half_extents_m.x() + s * half_extents_m.y(), s * half_extents_m.x() + c * half_extents_m.y(),
                  half_extents_m.z());
  return {on_grid(Vec3(p_WO - half)), on_grid(Vec3(p_WO + half))};
}

std::optional<Box> ObjectState::interior_W() const {
  if (!interior) return std::nullopt;
  const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
  Vec3 half = (interior->max - interior->min) / 2;
  half.head<2>() *= std::min(half.x() / (c * half.x() + s * half.y()), half.y() / (s * half.x() + c * half.y()));
  const Vec3 center_W = p_WO + Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * interior->center();
  return Box{on_grid(Vec3(center_W - half)), on_grid(Vec3(center_W + half))};
}

const ObjectState* WorldSnapshot::find(std::string_view name) const {
  for (const auto& object : objects)
    if (object.name == name) return &object;
  return nullptr;
}

}  // namespace continua
