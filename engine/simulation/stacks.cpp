#include "continua/simulation/stacks.h"

#include <algorithm>

#include "continua/simulation/oriented_box.h"

namespace continua {

namespace {

constexpr double gap_m = 0.01;  // things at this distance touch

}  // namespace

std::vector<std::string> standing_on(const ObjectState& object, const WorldSnapshot& world) {
  std::vector<const ObjectState*> found{&object};
  for (std::size_t i = 0; i < found.size(); ++i) {
    OrientedBox above = box_of(*found[i]);
    const double top = above.center_W.z() + above.half_m.z();
    above.center_W.z() += gap_m;
    for (const auto& other : world.objects) {
      if (other.name == object.name || std::find(found.begin(), found.end(), &other) != found.end()) continue;
      if (other.bounds_W().min.z() < top - gap_m) continue;
      if (overlap_depth(above, box_of(other)) > 0) found.push_back(&other);
    }
  }
  std::vector<std::string> names;
  for (std::size_t i = 1; i < found.size(); ++i) names.push_back(found[i]->name);
  return names;
}

std::vector<const ObjectState*> apart_from(const ObjectState& object, const WorldSnapshot& world) {
  const auto riders = standing_on(object, world);
  std::vector<const ObjectState*> others;
  for (const auto& other : world.objects) {
    if (other.name != object.name && std::find(riders.begin(), riders.end(), other.name) == riders.end())
      others.push_back(&other);
  }
  return others;
}

double height_under(const ObjectState& object, const WorldSnapshot& world) {
  constexpr double grazing_m = 0.001;
  const double bottom = object.bounds_W().min.z();
  double height = world.table.max.z();
  for (const ObjectState* other : apart_from(object, world)) {
    const double top = other->bounds_W().max.z();
    if (top > bottom + gap_m || overlap_depth(column_of(object), box_of(*other)) < grazing_m) continue;
    height = std::max(height, top);
  }
  return height;
}

}  // namespace continua
