#include "continua/simulation/set_down.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "continua/body/standing.h"
#include "continua/core/angles.h"
#include "continua/simulation/oriented_box.h"
#include "continua/simulation/stacks.h"

namespace continua {

namespace {

constexpr double rests_m = 0.001;
constexpr double level_m = 0.005;  // things whose bottoms differ by less stand beside each other
constexpr double rim_part = 0.3;   // of a hollow thing's half width: the corners of its box that a round rim lacks

/// The space of the object at `p_W`, along the world's axes, with a little air at its sides, so that it does not graze
/// its neighbours, and none below, where it touches its support.
OrientedBox box_at(const ObjectState& object, const Vec3& p_W) {
  constexpr double air_m = 0.0008;
  const bool swapped = static_cast<int>(std::lround(object.yaw / quarter_turn)) % 2 != 0;
  const Vec3& half = object.half_extents_m;
  const Vec3 turned(swapped ? half.y() : half.x(), swapped ? half.x() : half.y(), half.z());
  return {p_W, Eigen::Matrix3d::Identity(), turned + Vec3(air_m, air_m, -rests_m)};
}

/// The areas of contact with `bearers`, all equally high, carry the object's centre.
bool bear(const std::vector<const ObjectState*>& bearers, const OrientedBox& box) {
  constexpr double margin_m = 0.006;
  constexpr int directions = 16;
  // In each direction some contact must lie beyond the centre.
  for (int i = 0; i < directions; ++i) {
    const Vec3 direction(std::cos(full_turn * i / directions), std::sin(full_turn * i / directions), 0);
    double farthest = 0;
    for (const auto* bearer : bearers) {
      Box top = bearer->bounds_W();
      if (bearer->interior) {  // the rim of a round one bears no corner of its box
        const Vec3 off = rim_part * (top.max - top.min) / 2;
        top = {top.min + off, top.max - off};
      }
      const Vec3 low = (box.center_W - box.half_m).cwiseMax(top.min),
                 high = (box.center_W + box.half_m).cwiseMin(top.max);
      if (low.x() >= high.x() || low.y() >= high.y()) continue;
      const Vec3 corner(direction.x() > 0 ? high.x() : low.x(), direction.y() > 0 ? high.y() : low.y(), 0);
      const Vec3 reach = corner - box.center_W;
      farthest = std::max(farthest, reach.x() * direction.x() + reach.y() * direction.y());
    }
    if (farthest < margin_m) return false;
  }
  return true;
}

class Surroundings {
 public:
  Surroundings(const ObjectState& object, const WorldSnapshot& world)
      : object_(object), world_(world), others_(apart_from(object, world)) {}

  /// Things in the object's way down to `p_W`.
  std::vector<const ObjectState*> in_the_way(const Vec3& p_W) const {
    std::vector<const ObjectState*> found;
    for (const auto* other : others_) {
      if (overlap_depth(box_at(object_, p_W), column_of(*other)) > 0) found.push_back(other);
    }
    return found;
  }

  bool free(const Vec3& p_W) const { return bears(world_.table, p_W) && in_the_way(p_W).empty(); }

  std::vector<Vec3> free_places(const Vec3& p_W, double most_m, double step_m) const {
    constexpr int directions = 16;
    std::vector<Vec3> places;
    for (double r = step_m; r <= most_m; r += step_m) {
      for (int i = 0; i < directions; ++i) {
        const double angle = full_turn * i / directions;
        const Vec3 p = p_W + r * Vec3(std::cos(angle), std::sin(angle), 0);
        if (free(p)) places.push_back(p);
      }
    }
    return places;
  }

  /// Places to set the object down for a harmless straight shove into the goal, shortest shove first.
  std::vector<Vec3> shove_starts(const Vec3& p_WG) const {
    constexpr double step_m = 0.004, farthest_m = 0.09;
    const auto pushed = in_the_way(p_WG);
    const OrientedBox box = box_at(object_, p_WG);
    std::vector<std::pair<double, Vec3>> starts;
    for (const Vec3& away : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
      for (double r = step_m; r < farthest_m; r += step_m) {
        if (!free(p_WG + r * away)) continue;
        const bool harmless = std::all_of(pushed.begin(), pushed.end(), [&](const ObjectState* other) {
          // The other thing ends against the object's face. A thing at another height would be hit, not pushed.
          const Box theirs = other->bounds_W();
          if (std::abs(theirs.min.z() - (p_WG.z() - object_.half_extents_m.z())) > level_m) return false;
          const Vec3 mine = box.half_m.cwiseProduct(away.cwiseAbs());
          const double by = away.sum() > 0 ? (theirs.max - (box.center_W - mine)).dot(away)
                                           : ((box.center_W + mine) - theirs.min).dot(-away);
          return bears(world_.table, other->p_WO - by * away);
        });
        if (harmless) starts.push_back({r, p_WG + r * away});
        break;
      }
    }
    std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Vec3> places;
    for (const auto& [r, p] : starts) places.push_back(p);
    return places;
  }

 private:
  const ObjectState& object_;
  const WorldSnapshot& world_;
  std::vector<const ObjectState*> others_;
};

}  // namespace

std::vector<SetDown> set_downs(const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world,
                               double within_m) {
  constexpr double step_m = 0.003;
  const Surroundings around(object, world);
  std::vector<SetDown> ways;
  Vec3 goal = p_WG;
  // Upward, as long as the things there bear the object.
  for (std::size_t i = 0; i <= world.objects.size(); ++i) {
    const auto found = around.in_the_way(goal);
    if (found.empty() && bears(world.table, goal)) ways.push_back({goal, std::nullopt});
    for (const Vec3& p : around.free_places(goal, within_m, step_m)) ways.push_back({p, std::nullopt});
    if (found.empty()) break;
    double top = 0;
    for (const auto* other : found) top = std::max(top, other->bounds_W().max.z());
    std::vector<const ObjectState*> bearers;
    for (const auto* other : found) {
      if (other->bounds_W().max.z() > top - rests_m) bearers.push_back(other);
    }
    if (!bear(bearers, box_at(object, goal))) break;
    goal.z() = top + object.half_extents_m.z();
  }
  if (bears(world.table, goal)) {
    for (const Vec3& p : around.shove_starts(goal)) ways.push_back({goal, p});
  }
  return ways;
}

bool is_free(const ObjectState& object, const Vec3& p_W, const WorldSnapshot& world) {
  return Surroundings(object, world).free(p_W);
}

std::vector<Vec3> free_places(const ObjectState& object, const Vec3& p_W, const WorldSnapshot& world, double most_m,
                              double step_m) {
  return Surroundings(object, world).free_places(p_W, most_m, step_m);
}

}  // namespace continua
