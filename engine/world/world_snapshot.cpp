#include "world/world_snapshot.h"

#include <cmath>

namespace continua {

Box ObjectState::bounds_W() const {
  const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
  const Vec3 half(c * half_extents_m.x() + s * half_extents_m.y(), s * half_extents_m.x() + c * half_extents_m.y(),
                  half_extents_m.z());
  return {on_grid(Vec3(p_WO - half)), on_grid(Vec3(p_WO + half))};
}

const ObjectState* WorldSnapshot::find(std::string_view name) const {
  for (const auto& object : objects)
    if (object.name == name) return &object;
  return nullptr;
}

}  // namespace continua
