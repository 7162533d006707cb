#include "continua/simulation/pushing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "continua/body/standing.h"
#include "continua/core/angles.h"
#include "continua/simulation/hand_route.h"
#include "continua/simulation/stacks.h"

namespace continua {

namespace {

using Code = ReasonCode;

constexpr double tips_above_m = 0.002;  // above the table: the fingers meet flat things too
constexpr double on_table_m = 0.005;    // an object no farther above the table stands on it

const ObjectShape* shape_of(const ObjectState& object, const Means& means) {
  const auto found = means.shapes.find(object.name);
  return found == means.shapes.end() ? nullptr : &found->second;
}

bool is_round(const ObjectState& object, const Means& means) {
  const ObjectShape* shape = shape_of(object, means);
  return shape && shape->is_round();
}

/// A straight part of the way, along one direction.
struct Leg {
  Vec3 ahead_W = Vec3::UnitX();
  double length_m = 0;
  double half_m = 0;         ///< half extent of the object along the way
  double half_across_m = 0;  ///< half extent across the way
};

/// Legs to the goal, longest first.
std::vector<Leg> legs_to(const ObjectState& object, const Vec3& p_WG, const Means& means) {
  const Vec3 way(p_WG.x() - object.p_WO.x(), p_WG.y() - object.p_WO.y(), 0);
  const Vec3& half = object.half_extents_m;
  std::vector<Leg> legs;
  if (is_round(object, means)) {
    if (way.norm() > pushed_m) legs.push_back({way.normalized(), way.norm(), half.x(), half.y()});
    return legs;
  }
  const Eigen::AngleAxisd R_WO(object.yaw, Vec3::UnitZ());
  for (const int axis : {0, 1}) {
    const Vec3 along_W = R_WO * Vec3::Unit(axis);
    const double by_m = way.dot(along_W);
    if (std::abs(by_m) > pushed_m)
      legs.push_back({by_m > 0 ? along_W : Vec3(-along_W), std::abs(by_m), half[axis], half[1 - axis]});
  }
  std::stable_sort(legs.begin(), legs.end(), [](const Leg& a, const Leg& b) { return a.length_m > b.length_m; });
  return legs;
}

/// The height of the pushing hand: as low as it gets, but for a hand with short fingers, whose palm stays above the
/// object as long as the tips meet the lower half.
double height_of_push(const ObjectState& object, const WorldSnapshot& world, const HandShape& hand) {
  const double lowest = world.table.max.z() + hand.finger_tip_m + tips_above_m;
  const double over = object.bounds_W().max.z() + tips_above_m - hand.palm_front_m;
  return over - hand.finger_tip_m < object.p_WO.z() ? std::max(lowest, over) : lowest;
}

OrReason<Push> push_along(const Leg& leg, const ObjectState& object, const std::string& landmark,
                          const WorldSnapshot& world, const Means& means) {
  constexpr double part_of_face = 0.5;  // of its half width: fingers there keep the object from turning
  constexpr double widest_m = 0.03;
  constexpr double inscribed = 0.7;                     // the square in a circle
  constexpr std::array gaps_m = {0.012, 0.007, 0.003};  // between fingers and face as the hand comes down
  if (const auto other = met_on_way(object, object.p_WO + leg.length_m * leg.ahead_W, landmark, world))
    return Reason{Code::in_the_way, {*other, object.name}};

  const AvatarForm& avatar = means.avatar;
  const HandShape& hand = avatar.hand;
  Push push;
  push.ahead_W = leg.ahead_W;
  push.opening_m = std::max(0.0, std::min(part_of_face * leg.half_across_m, widest_m) - hand.finger_thickness_m / 2);
  // A round thing bulges back between the fingers.
  double touched_m = leg.half_m;
  if (is_round(object, means))
    touched_m = std::sqrt(std::max(0.0, leg.half_m * leg.half_m - push.opening_m * push.opening_m));
  Vec3 contact_W = object.p_WO - (touched_m + hand.finger_half_width_m) * leg.ahead_W;
  contact_W.z() = height_of_push(object, world, hand);

  std::vector<OrientedBox> others;
  for (const auto& other : world.objects)
    if (other.name != object.name) others.push_back(column_of(other));
  OrientedBox itself = box_of(object);
  if (is_round(object, means)) itself.half_m.head<2>() *= inscribed;
  const double across = std::atan2(leg.ahead_W.y(), leg.ahead_W.x()) + half_turn / 2;
  bool has_room = false;
  for (const double gap_m : gaps_m) {
    for (const int turns : {0, 1, -1}) {
      const Vec3 behind_W = contact_W - gap_m * leg.ahead_W;
      const double natural = avatar.natural_yaw(behind_W);
      const double yaw = across + half_turn * (std::round((natural - across) / half_turn) + turns);
      if (!avatar.wrist_turns(yaw - natural)) continue;
      push.behind_X_WT = {behind_W, rotation({yaw, 0})};
      push.end_X_WT = {contact_W + leg.length_m * leg.ahead_W, push.behind_X_WT.R_WB};
      auto around = others;
      around.push_back(itself);
      if (hand_conflict(hand, push.behind_X_WT, push.opening_m, around) > 0 ||
          hand_conflict(hand, push.end_X_WT, push.opening_m, others) > 0)
        continue;
      has_room = true;
      const auto behind = find_ik(avatar.arm, push.behind_X_WT);
      if (behind && solve_ik(avatar.arm, before_grasp(push.behind_X_WT), *behind).reached &&
          solve_ik(avatar.arm, push.end_X_WT, *behind).reached)
        return push;
    }
  }
  if (!has_room) return Reason{Code::no_room_behind, {object.name}};
  return Reason{Code::no_way_behind, {object.name}};
}

/// The first of the pushes to the goal.
OrReason<Push> first_push(const ObjectState& object, const Vec3& p_WG, const std::string& landmark,
                          const WorldSnapshot& world, const Means& means) {
  std::optional<Reason> first;
  for (const Leg& leg : legs_to(object, p_WG, means)) {
    auto push = push_along(leg, object, landmark, world, means);
    WorldSnapshot after = world;
    for (auto& other : after.objects)
      if (other.name == object.name) other.p_WO += leg.length_m * leg.ahead_W;
    const ObjectState& moved = *after.find(object.name);
    if (push && needs_push(moved, p_WG, means)) {
      const auto next = first_push(moved, p_WG, landmark, after, means);
      if (!next) push = next.reason();
    }
    if (push) return push;
    if (!first) first = push.reason();
  }
  require(first.has_value(), "what is pushed is not where it shall be");
  return *first;
}

}  // namespace

bool needs_push(const ObjectState& object, const Vec3& p_WG, const Means& means) {
  return !legs_to(object, p_WG, means).empty();
}

OrReason<Push> plan_push(const ObjectState& object, const Vec3& p_WG, const std::string& landmark,
                         const WorldSnapshot& world, const Means& means) {
  if (object.bounds_W().min.z() - world.table.max.z() > on_table_m) return Reason{Code::not_on_table, {object.name}};
  if (std::abs(p_WG.z() - object.p_WO.z()) > on_table_m) return Reason{Code::only_along_table, {object.name}};
  constexpr double margin_m = 0.01;  // a push may go a little too far
  if (!bears(world.table, p_WG, margin_m)) return Reason{Code::falls_off, {object.name}};
  return first_push(object, p_WG, landmark, world, means);
}

}  // namespace continua
