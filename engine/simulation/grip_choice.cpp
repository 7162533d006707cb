#include "simulation/grip_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/stacks.h"

namespace continua {

namespace {

constexpr double quarter = 1.5707963267948966;
constexpr double least_conflict_m = 1e-4;  // what is on the grid cannot be told from touching below this
constexpr double widest_wrist = 2.9;       // radians from natural: a little within the last hinge's limits

// Tilted, the hand takes what others stand on, or what stands below something high.
constexpr std::array tilts = {0.0, 0.7, -0.7};
// Of the object's half width: beside its middle, where a neighbour covers the rest of a face.
constexpr std::array shifts = {0.0, 0.35, -0.35, 0.6, -0.6};
// Of each open finger from the object.
constexpr std::array margins_m = {0.008, 0.004, 0.002};

/// `angle` plus whole turns of `period`, as near to `wanted` as can be.
double nearest(double angle, double period, double wanted) {
  return angle + period * std::round((wanted - angle) / period);
}

double beyond_slack(double conflict_m) { return conflict_m < least_conflict_m ? 0 : conflict_m; }

bool is_square(const ObjectState& object) {
  return std::abs(object.half_extents_m.x() - object.half_extents_m.y()) < 1e-3;
}

}  // namespace

Pose hand_at(const Grip& grip, const Vec3& p_WO, bool turned) {
  const Eigen::Quaterniond R(Eigen::AngleAxisd(turned ? grip.turn : 0, Vec3::UnitZ()));
  return {p_WO + R * grip.p_OT, R * rotation(grip.hand)};
}

std::vector<Grip> grips_on(const ObjectState& object, const WorldSnapshot& world, const Vec3& base_W) {
  const HandShape hand;
  std::vector<OrientedBox> others;
  for (const auto& other : world.objects) {
    if (other.name != object.name) others.push_back(column_of(other));
  }
  // Held at its middle, but flat things so that the finger tips stay above what they stand on.
  const double height = std::max(0.0, hand.finger_tip_m + 0.003 - object.half_extents_m.z());
  const double natural = natural_yaw(object.p_WO, base_W);

  std::vector<Grip> grips;
  for (const int side : {0, 1}) {
    const double half = side == 0 ? object.half_extents_m.x() : object.half_extents_m.y();
    const double across = side == 0 ? object.half_extents_m.y() : object.half_extents_m.x();
    const double yaw = nearest(object.yaw + side * quarter, 2 * quarter, natural);
    const Vec3 sideways(-std::sin(yaw), std::cos(yaw), 0);
    for (const double margin_m : margins_m) {
      const double opening_m = half + margin_m;
      if (opening_m > hand.widest_opening_m) continue;
      for (const double tilt : tilts) {
        for (const double shift : shifts) {
          Grip grip{{yaw, tilt}, Vec3(0, 0, height) + shift * across * sideways, 0, opening_m, 0, 0};
          grip.conflict_m = beyond_slack(hand_conflict(hand_at(grip, object.p_WO, false), opening_m, others));
          // The middle of the object, wide fingers, the hand upright, little turning of the wrist.
          grip.cost = 0.5 * std::abs(shift) + 20 * (margins_m[0] - margin_m) + 0.3 * std::abs(tilt) +
                      0.02 * std::abs(yaw - natural);
          grips.push_back(grip);
        }
      }
    }
  }
  std::stable_sort(grips.begin(), grips.end(), [](const Grip& a, const Grip& b) { return a.cost < b.cost; });
  return grips;
}

std::vector<Grip> grips_at(const Grip& grip, const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world,
                           const Vec3& base_W) {
  std::vector<OrientedBox> others;
  for (const ObjectState* other : apart_from(object, world)) others.push_back(column_of(*other));
  const double straighten = nearest(0, quarter, object.yaw) - object.yaw;
  const double start_wrist = std::remainder(grip.hand.yaw - natural_yaw(object.p_WO, base_W), 4 * quarter);
  const double yaw = natural_yaw(object.p_WO, base_W) + start_wrist;
  std::vector<Grip> grips;
  for (const int quarters : {0, 1, -1, 2, -2}) {
    if (quarters % 2 != 0 && !is_square(object)) continue;
    Grip turned = grip;
    turned.turn = straighten + quarters * quarter;
    const double wrist = yaw + turned.turn - natural_yaw(p_WG, base_W);
    if (quarters != 0 && std::abs(wrist) > widest_wrist) continue;
    const double conflict_m = hand_conflict(hand_at(turned, p_WG, true), grip.opening_m, others);
    turned.conflict_m = std::max(grip.conflict_m, beyond_slack(conflict_m));
    turned.cost += 0.05 * std::abs(turned.turn) + 0.02 * std::abs(wrist) + (std::abs(wrist) > widest_wrist ? 10 : 0);
    grips.push_back(turned);
  }
  return grips;
}

}  // namespace continua
