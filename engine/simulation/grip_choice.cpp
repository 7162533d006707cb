#include "simulation/grip_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace continua {

namespace {

constexpr double quarter = 1.5707963267948966;

/// Box around a part of the hand: `along` and `across` the closing direction, which has `yaw`.
Box part(const Vec3& p_WT, double yaw, double along_min, double along_max, double across, double z_min, double z_max) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  const double middle = (along_min + along_max) / 2, half = (along_max - along_min) / 2;
  const Vec3 center = p_WT + Vec3(c * middle, s * middle, 0);
  const Vec3 reach(std::abs(c) * half + std::abs(s) * across, std::abs(s) * half + std::abs(c) * across, 0);
  return {center - reach + Vec3(0, 0, z_min), center + reach + Vec3(0, 0, z_max)};
}

/// How deep a hand that is open by `opening_m` would be in other things.
double conflict(const HandShape& hand, const Vec3& p_WT, double yaw, double opening_m, const std::vector<Box>& others) {
  const double outside = opening_m + hand.finger_thickness_m;
  const std::array parts = {
      part(p_WT, yaw, opening_m, outside, hand.finger_half_width_m, hand.finger_tip_m, hand.palm_bottom_m),
      part(p_WT, yaw, -outside, -opening_m, hand.finger_half_width_m, hand.finger_tip_m, hand.palm_bottom_m),
      part(p_WT, yaw, -hand.palm_half_length_m, hand.palm_half_length_m, hand.palm_half_width_m, hand.palm_bottom_m,
           hand.palm_top_m)};
  double deepest = 0;
  for (const Box& box : others) {
    for (const Box& piece : parts) deepest = std::max(deepest, overlap_depth(piece, box));
  }
  return deepest;
}

/// `angle` plus whole turns of `period`, as near to `wanted` as can be.
double nearest(double angle, double period, double wanted) {
  return angle + period * std::round((wanted - angle) / period);
}

}  // namespace

double natural_yaw(const Vec3& p_W, const Vec3& base_W) {
  return std::atan2(p_W.x() - base_W.x(), base_W.y() - p_W.y());
}

double overlap_depth(const Box& a, const Box& b) {
  const Vec3 depth = a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min);
  return std::max(0.0, depth.minCoeff());
}

std::vector<std::string> standing_on(const ObjectState& object, const WorldSnapshot& world) {
  constexpr double contact_m = 0.01;
  std::vector<const ObjectState*> found{&object};
  for (std::size_t i = 0; i < found.size(); ++i) {
    Box top = found[i]->bounds_W();
    top.min.z() = top.max.z() - contact_m;
    top.max.z() += contact_m;
    for (const auto& other : world.objects) {
      Box bottom = other.bounds_W();
      if (std::find(found.begin(), found.end(), &other) != found.end() || bottom.min.z() < top.min.z()) continue;
      if (overlap_depth(top, bottom) > 0) found.push_back(&other);
    }
  }
  std::vector<std::string> names;
  for (std::size_t i = 1; i < found.size(); ++i) names.push_back(found[i]->name);
  return names;
}

std::optional<Grip> choose_grip(const ObjectState& object, const WorldSnapshot& world, const std::optional<Vec3>& p_WG,
                                const Vec3& base_W, const HandShape& hand) {
  const auto riders = standing_on(object, world);
  std::vector<Box> others, others_at_goal;
  for (const auto& other : world.objects) {
    if (other.name == object.name) continue;
    others.push_back(other.bounds_W());
    if (std::find(riders.begin(), riders.end(), other.name) == riders.end()) others_at_goal.push_back(other.bounds_W());
  }

  // Held at its middle, but with flat things so that the finger tips stay above what they stand on.
  const double height = std::max(0.0, -object.half_extents_m.z() - hand.finger_tip_m + 0.003);
  const bool square = std::abs(object.half_extents_m.x() - object.half_extents_m.y()) < 1e-3;

  std::optional<Grip> best;
  double best_cost = 0;
  for (const int side : {0, 1}) {
    const double half = side == 0 ? object.half_extents_m.x() : object.half_extents_m.y();
    const double across = side == 0 ? object.half_extents_m.y() : object.half_extents_m.x();
    const double yaw = nearest(object.yaw + side * quarter, 2 * quarter, natural_yaw(object.p_WO, base_W));
    const Vec3 sideways(-std::sin(yaw), std::cos(yaw), 0);
    for (const double margin_m : {0.008, 0.004, 0.002}) {
      const double opening_m = half + margin_m;
      if (opening_m > hand.widest_opening_m) continue;
      for (const double shift : {0.0, 0.35, -0.35, 0.6, -0.6}) {
        const Vec3 p_OT = Vec3(0, 0, height) + shift * across * sideways;
        const double here = conflict(hand, object.p_WO + p_OT, yaw, opening_m, others);
        for (const int quarters : {0, 1}) {
          if ((quarters && !square) || (quarters && !p_WG)) continue;
          Grip grip{yaw, 0, p_OT, opening_m, here};
          double wrist = std::abs(yaw - natural_yaw(object.p_WO, base_W));
          if (p_WG) {
            // The object comes to lie along the world's axes.
            const double natural = natural_yaw(*p_WG, base_W);
            double yaw_at_goal = yaw - object.yaw + nearest(0, quarter, object.yaw) + quarters * quarter;
            if (quarters && std::abs(yaw_at_goal - 2 * quarter - natural) < std::abs(yaw_at_goal - natural))
              yaw_at_goal -= 2 * quarter;
            grip.turn = yaw_at_goal - yaw;
            const Vec3 p_GT = Eigen::AngleAxisd(grip.turn, Vec3::UnitZ()) * p_OT;
            grip.conflict_m = std::max(here, conflict(hand, *p_WG + p_GT, yaw_at_goal, opening_m, others_at_goal));
            wrist = std::max(wrist, std::abs(yaw_at_goal - natural));
          }
          // A conflict outweighs everything; then the middle of the object, wide fingers, little turning.
          const double cost = 1000 * grip.conflict_m + 0.5 * std::abs(shift) + 20 * (0.008 - margin_m) +
                              0.05 * std::abs(grip.turn) + 0.02 * wrist + (wrist > 2.9 ? 10 : 0);
          if (best && cost >= best_cost) continue;
          best = grip;
          best_cost = cost;
        }
      }
    }
  }
  return best;
}

}  // namespace continua
