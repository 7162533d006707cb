#include "simulation/set_down.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/grip_choice.h"

namespace continua {

namespace {

/// The room the object needs when its centre is at `p_W`: a little air at its sides, so that it comes down without
/// grazing what it shall stand beside, and none below, where it shall touch.
Box box_at(const ObjectState& object, const Vec3& p_W) {
  constexpr double air_m = 0.0008, touching_m = 0.001;
  const Box box = object.bounds_W();
  const Vec3 half = (box.max - box.min) / 2 + Vec3(air_m, air_m, -touching_m);
  return {p_W - half, p_W + half};
}

/// Whether the table, or what the goal stands on, still bears an object there: its centre is above it.
bool on_table(const Vec3& p_W, const Box& table) {
  constexpr double margin_m = 0.005;
  return p_W.x() > table.min.x() + margin_m && p_W.x() < table.max.x() - margin_m &&
         p_W.y() > table.min.y() + margin_m && p_W.y() < table.max.y() - margin_m;
}

class Surroundings {
 public:
  Surroundings(const ObjectState& object, const WorldSnapshot& world) : object_(object), world_(world) {
    const auto riders = standing_on(object, world);
    for (const auto& other : world.objects) {
      if (other.name != object.name && std::find(riders.begin(), riders.end(), other.name) == riders.end())
        others_.push_back(&other);
    }
  }

  std::vector<const ObjectState*> in_the_way(const Vec3& p_W) const {
    std::vector<const ObjectState*> found;
    for (const auto* other : others_) {
      if (overlap_depth(box_at(object_, p_W), other->bounds_W()) > 0) found.push_back(other);
    }
    return found;
  }

  bool free(const Vec3& p_W) const { return on_table(p_W, world_.table) && in_the_way(p_W).empty(); }

  /// The free place nearest to `p_W` and no farther than `most_m`.
  std::optional<Vec3> nearest_free(const Vec3& p_W, double most_m) const {
    constexpr double step_m = 0.001;
    constexpr int directions = 16;
    for (double r = step_m; r <= most_m; r += step_m) {
      for (int i = 0; i < directions; ++i) {
        const double angle = 6.283185307179586 * i / directions;
        const Vec3 p = p_W + r * Vec3(std::cos(angle), std::sin(angle), 0);
        if (free(p)) return p;
      }
    }
    return std::nullopt;
  }

  /// Where to set the object down so that a straight push from there clears the goal, if such a push does no harm.
  std::optional<Vec3> shove_start(const Vec3& p_WG) const {
    constexpr double step_m = 0.004, farthest_m = 0.09;
    const auto pushed = in_the_way(p_WG);
    std::optional<Vec3> best;
    double best_m = farthest_m;
    for (const Vec3& away : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
      for (double r = step_m; r < best_m; r += step_m) {
        if (!free(p_WG + r * away)) continue;
        const bool harmless = std::all_of(pushed.begin(), pushed.end(), [&](const ObjectState* other) {
          // It comes to lie against the object's face.
          const Box mine = box_at(object_, p_WG), theirs = other->bounds_W();
          const double by = away.sum() > 0 ? (theirs.max - mine.min).dot(away) : (mine.max - theirs.min).dot(-away);
          return on_table(other->p_WO - by * away, world_.table);
        });
        if (harmless) {
          best = p_WG + r * away;
          best_m = r;
        }
        break;
      }
    }
    return best;
  }

 private:
  const ObjectState& object_;
  const WorldSnapshot& world_;
  std::vector<const ObjectState*> others_;
};

/// Whether `other` bears an object whose centre is above it at `p_W`.
bool bears(const ObjectState& other, const Vec3& p_W) {
  constexpr double margin_m = 0.006;
  const Box top = other.bounds_W();
  return p_W.x() > top.min.x() + margin_m && p_W.x() < top.max.x() - margin_m && p_W.y() > top.min.y() + margin_m &&
         p_W.y() < top.max.y() - margin_m;
}

}  // namespace

SetDown choose_set_down(const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world, double near_m) {
  const Surroundings around(object, world);
  Vec3 goal = p_WG;
  // Upward, as long as something there bears the object.
  for (std::size_t i = 0; i <= world.objects.size(); ++i) {
    const auto found = around.in_the_way(goal);
    if (found.empty()) return {goal, std::nullopt};
    if (const auto beside = around.nearest_free(goal, near_m)) return {*beside, std::nullopt};
    const auto bearer =
        std::find_if(found.begin(), found.end(), [&](const auto* other) { return bears(*other, goal); });
    if (bearer == found.end()) break;
    goal.z() = (*bearer)->bounds_W().max.z() + object.half_extents_m.z();
  }
  if (const auto start = around.shove_start(goal)) return {goal, start};
  constexpr double farthest_m = 0.2;
  return {around.nearest_free(goal, farthest_m).value_or(goal), std::nullopt};
}

}  // namespace continua
