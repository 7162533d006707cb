#include "continua/simulation/turning.h"

#include <algorithm>
#include <cmath>

#include "continua/core/angles.h"
#include "continua/simulation/hand_route.h"
#include "continua/simulation/stacks.h"

namespace continua {

namespace {

// In the unit of grip_choice.cpp. For each radian of the wrist before and after the turn: among grips as good, the one
// with the most play at both ends.
constexpr double turn_cost_per_rad = 0.05;
// The long way round: as much as two radians of the wrist.
constexpr double round_cost = 0.1;
// A turn by the long way may be half a turn and a rounding, no more.
constexpr double most_turn = 1.01 * half_turn;

/// The grips, and the upright ones again with the hand the other way round: another posture of the wrist.
std::vector<Grip> both_ways_round(std::vector<Grip> grips) {
  const std::size_t count = grips.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (grips[i].hand.tilt != 0 || grips[i].hand.roll != 0) continue;
    for (const double by : {half_turn, -half_turn}) {
      grips.push_back(grips[i]);
      grips.back().hand.yaw += by;
    }
  }
  return grips;
}

}  // namespace

std::optional<Handling> plan_turn(const Task& task, double by_rad, const WorldSnapshot& world, const Means& means,
                                  const std::optional<Grasp>& grasp, const std::vector<Grip>& tried) {
  const ObjectState& object = *world.find(task.object);
  const AvatarForm& avatar = means.avatar;
  const double natural = avatar.natural_yaw(object.p_WO);
  auto grips = starts_of(task, world, means, grasp);
  if (grips.empty()) return std::nullopt;
  if (!grasp) grips = both_ways_round(std::move(grips));

  std::vector<OrientedBox> others;
  for (const ObjectState* other : apart_from(object, world)) others.push_back(box_of(*other));
  std::vector<Grip> turned;
  for (const Grip& grip : grips) {
    for (const double round : {0.0, -2 * half_turn, 2 * half_turn}) {
      const double by = by_rad + round, wrist = std::remainder(grip.hand.yaw - natural, 2 * half_turn);
      // The same grip with another turn of the wrist is among those the other way round.
      if (!avatar.wrist_turns(grip.hand.yaw - natural) && !grasp) continue;
      if (std::abs(by) > most_turn || !avatar.wrist_turns(wrist + by)) continue;
      Grip one = grip;
      one.turn = by;
      one.conflict_m =
          std::max(grip.conflict_m, hand_conflict(avatar.hand, hand_at(one, object.p_WO, true), one.opening_m, others));
      for (const Grip& before : tried) one.cost += alike(grip, before) ? tried_cost : 0;
      one.cost += turn_cost_per_rad * (std::abs(wrist) + std::abs(wrist + by)) + (round == 0 ? 0 : round_cost);
      turned.push_back(one);
    }
  }
  std::stable_sort(turned.begin(), turned.end(), [](const Grip& a, const Grip& b) {
    return std::pair(a.conflict_m, a.cost) < std::pair(b.conflict_m, b.cost);
  });

  ObjectState after = object;
  after.yaw += by_rad;
  const bool fits = std::none_of(others.begin(), others.end(), [&](const OrientedBox& other) {
    constexpr double slack_m = 5e-4;  // things that touch it now may do so afterwards
    return overlap_depth(box_of(after), other) > std::max(slack_m, overlap_depth(box_of(object), other));
  });
  Handling best;
  best.object = task.object;
  constexpr std::size_t most_tries = 100;  // each costs some solutions of the inverse kinematics
  for (std::size_t i = 0; i < std::min(turned.size(), most_tries); ++i) {
    const auto start = find_ik(avatar.arm, hand_at(turned[i], object.p_WO, false));
    if (!start || !find_ik(avatar.arm, hand_at(turned[i], object.p_WO, true))) continue;
    if (!grasp && !solve_ik(avatar.arm, before_grasp(hand_at(turned[i], object.p_WO, false)), *start).reached) continue;
    best.grip = turned[i];
    best.set_down = SetDown{object.p_WO, std::nullopt};
    best.reached = true;
    best.has_room = fits && turned[i].conflict_m == 0;
    break;
  }
  return best;
}

}  // namespace continua
