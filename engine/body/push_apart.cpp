#include "continua/body/push_apart.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "continua/body/standing.h"

namespace continua {
namespace {

constexpr int most_pushes = 200;

struct Overlap {
  std::size_t a = 0, b = 0;
  int axis = 0;      ///< x or y, along which it is shorter
  double depth = 0;  ///< metres
};

Overlap overlap_of(std::size_t a, std::size_t b, const WorldSnapshot& world) {
  const Box one = world.objects[a].bounds_W(), other = world.objects[b].bounds_W();
  const Vec3 depth = one.max.cwiseMin(other.max) - one.min.cwiseMax(other.min);
  const int axis = depth.x() <= depth.y() ? 0 : 1;
  return {a, b, axis, depth[axis]};
}

// The deepest overlap that concerns a pushed thing.
std::optional<Overlap> deepest(const WorldSnapshot& world, const std::vector<bool>& pushed) {
  std::optional<Overlap> found;
  for (std::size_t a = 0; a < world.objects.size(); ++a)
    for (std::size_t b = 0; b < world.objects.size(); ++b) {
      if (a == b || !pushed[a] || (pushed[b] && b < a) || !overlap(world.objects[a], world.objects[b])) continue;
      const auto one = overlap_of(a, b, world);
      if (!found || one.depth > found->depth) found = one;
    }
  return found;
}

// The thing is in the other one, directly or within a third.
bool is_within(std::size_t thing, std::size_t container, const WorldSnapshot& world) {
  return thing != container && is_inside(world.objects[thing], world.objects[container]);
}

void shift(WorldSnapshot& world, std::size_t object, int axis, double by_m) {
  std::vector<bool> moves;
  for (std::size_t i = 0; i < world.objects.size(); ++i) moves.push_back(i == object || is_within(i, object, world));
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (moves[i]) world.objects[i].p_WO[axis] = on_grid(world.objects[i].p_WO[axis] + by_m);
}

// Things fall that have lost their support, the lowest first.
void let_fall(WorldSnapshot& world, const std::vector<bool>& stood_on_pushed) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < stood_on_pushed.size(); ++i)
    if (stood_on_pushed[i]) order.push_back(i);
  const auto bottom = [&](std::size_t i) { return world.objects[i].bounds_W().min.z(); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return bottom(a) < bottom(b); });
  for (const auto i : order) {
    auto& object = world.objects[i];
    object.p_WO.z() = on_grid(object.p_WO.z() + height_below(object, world) - bottom(i));
  }
}

}  // namespace

WorldSnapshot pushed_apart(WorldSnapshot world, const std::string& object, GivesWay gives_way) {
  std::vector<bool> pushed, above(world.objects.size(), false);
  for (const auto& one : world.objects) pushed.push_back(one.name == object);
  const auto push = [&](std::size_t i, int axis, double by_m) {
    const auto carried = carried_with(world.objects[i].name, world);
    for (std::size_t k = 0; k < carried.size(); ++k)
      if (carried[k] && k != i && !is_within(k, i, world)) above[k] = true;
    shift(world, i, axis, by_m);
    pushed[i] = true;
  };
  for (int pushes = 0; pushes < most_pushes; ++pushes) {
    const auto found = deepest(world, pushed);
    if (!found) break;
    const auto& [a, b, axis, depth] = *found;
    const double way = world.objects[a].p_WO[axis] <= world.objects[b].p_WO[axis] ? -1 : 1;
    const auto stays = [&](std::size_t i) { return gives_way == GivesWay::others && world.objects[i].name == object; };
    const double share_of_a = stays(a) ? 0 : stays(b) ? 1 : 0.5;
    push(a, axis, way * depth * share_of_a);
    push(b, axis, -way * depth * (1 - share_of_a));
  }
  let_fall(world, above);
  return world;
}

}  // namespace continua
