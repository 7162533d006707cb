#include "continua/perception/ray_cast.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace continua {
namespace {

// The length along the ray, in units of its direction, at which it enters the box; infinite if it misses it. By slabs:
// a ray is inside the box while it is between the two planes of each axis.
double entry(const Ray& ray, const Box& box_W) {
  constexpr double never = std::numeric_limits<double>::infinity();
  double enters = 0, leaves = never;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = ray.from_W[axis], along = ray.direction_W[axis];
    if (along == 0) {
      if (from < box_W.min[axis] || from > box_W.max[axis]) return never;
      continue;
    }
    const double a = (box_W.min[axis] - from) / along, b = (box_W.max[axis] - from) / along;
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return enters <= leaves ? enters : never;
}

}  // namespace

InputEvent with_target(InputEvent event, const WorldSnapshot& world) {
  if (event.target_W || !event.ray) return event;
  double first = std::numeric_limits<double>::infinity();
  for (const auto& object : world.objects)
    if (object.name != world.held) first = std::min(first, entry(*event.ray, object.bounds_W()));
  if (!std::isfinite(first)) return event;
  const Vec3 place_W = event.ray->from_W + first * event.ray->direction_W;
  event.target_W = on_grid(Vec3(place_W.x(), place_W.y(), 0));
  return event;
}

}  // namespace continua
