#include "continua/body/standing.h"

#include <algorithm>
#include <cmath>

namespace continua {

namespace {

// Faces at this distance touch.
constexpr double touch_m = 0.005;

/// Area in which two boxes overlap, seen from above.
double overlap_area(const Box& a, const Box& b) {
  const double x = std::min(a.max.x(), b.max.x()) - std::max(a.min.x(), b.min.x());
  const double y = std::min(a.max.y(), b.max.y()) - std::max(a.min.y(), b.min.y());
  return x > 0 && y > 0 ? x * y : 0;
}

/// Index of the object that bears `world.objects[i]`: the container around it, else the thing below it with the largest
/// overlap; -1 for the table.
int support_of(std::size_t i, const WorldSnapshot& world) {
  const ObjectState& object = world.objects[i];
  const Box box = object.bounds_W();
  int support = -1;
  double most = 0;
  for (std::size_t j = 0; j < world.objects.size(); ++j) {
    if (j == i) continue;
    if (is_inside(object, world.objects[j]) && box.min.z() < world.objects[j].interior_W()->max.z())
      return static_cast<int>(j);
    const Box below = world.objects[j].bounds_W();
    if (std::abs(box.min.z() - below.max.z()) > touch_m) continue;
    const double area = overlap_area(box, below);
    if (area > most) {
      most = area;
      support = static_cast<int>(j);
    }
  }
  return support;
}

}  // namespace

bool is_inside(const ObjectState& thing, const ObjectState& container) {
  const auto hollow = container.interior_W();
  if (!hollow) return false;
  const Box box = thing.bounds_W();
  return box.min.x() >= hollow->min.x() - grid_slack_m && box.max.x() <= hollow->max.x() + grid_slack_m &&
         box.min.y() >= hollow->min.y() - grid_slack_m && box.max.y() <= hollow->max.y() + grid_slack_m &&
         box.min.z() >= hollow->min.z() - grid_slack_m;
}

bool bears(const Box& table, const Vec3& p_WO, double margin_m) {
  return p_WO.x() > table.min.x() + margin_m && p_WO.x() < table.max.x() - margin_m &&
         p_WO.y() > table.min.y() + margin_m && p_WO.y() < table.max.y() - margin_m;
}

bool overlap(const ObjectState& a, const ObjectState& b) {
  const Box one = a.bounds_W(), other = b.bounds_W();
  const Vec3 depth = one.max.cwiseMin(other.max) - one.min.cwiseMax(other.min);
  return depth.minCoeff() > grid_slack_m && !is_inside(a, b) && !is_inside(b, a);
}

std::vector<bool> carried_with(std::string_view object, const WorldSnapshot& world) {
  std::vector<bool> carried(world.objects.size(), false);
  std::vector<int> supports;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    supports.push_back(support_of(i, world));
    carried[i] = world.objects[i].name == object;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < carried.size(); ++i) {
      if (carried[i] || supports[i] < 0 || !carried[static_cast<std::size_t>(supports[i])]) continue;
      carried[i] = changed = true;
    }
  }
  return carried;
}

double height_below(const ObjectState& object, const WorldSnapshot& world) {
  const Box box = object.bounds_W();
  double height = world.table.max.z(), most = 0;
  for (const auto& other : world.objects) {
    if (other.name == object.name) continue;
    const Box below = other.bounds_W();
    const bool inside = is_inside(object, other);
    const double top = inside ? other.interior_W()->min.z() : below.max.z();
    if (top > box.min.z() + touch_m) continue;
    const double area = overlap_area(box, below);
    if (area < most || area == 0 || (area == most && top < height)) continue;
    most = area;
    height = top;
  }
  return height;
}

ObjectState stood_on_end(ObjectState lying) {
  Vec3& half = lying.half_extents_m;
  std::swap(half.x() >= half.y() ? half.x() : half.y(), half.z());
  lying.interior.reset();
  return lying;
}

}  // namespace continua
