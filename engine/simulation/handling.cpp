#include "continua/simulation/handling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "continua/core/angles.h"
#include "continua/simulation/hand_route.h"
#include "continua/simulation/stacks.h"

namespace continua {

namespace {

/// Reachability of poses, with room for the arm.
class Reach {
 public:
  Reach(const AvatarForm& avatar, const ObjectState& object, const WorldSnapshot& world) : avatar_(avatar) {
    // Things on the object go along with the hand, and count all the same.
    for (const auto& other : world.objects) {
      if (other.name != object.name) others_.push_back(box_of(other));
    }
  }

  bool reaches(const Pose& X_WT, bool& arm_free) {
    const auto posture = find_ik(avatar_.arm, X_WT);
    if (!posture || !solve_ik(avatar_.arm, before_grasp(X_WT), *posture).reached) return false;
    arm_free = arm_free && arm_conflict(avatar_, *posture, others_) == 0;
    return true;
  }

 private:
  const AvatarForm& avatar_;
  std::vector<OrientedBox> others_;
};

/// The free place nearest to a goal without a way there.
SetDown elsewhere(const Task& task, const ObjectState& object, const WorldSnapshot& world) {
  constexpr double farthest_m = 0.2;  // farther off is no answer to where it was asked for
  constexpr double step_m = 0.004;
  const auto places = free_places(object, *task.p_WG, world, farthest_m, step_m);
  return {places.empty() ? *task.p_WG : places.front(), std::nullopt};
}

/// Ways to set the object down at its goal; in a hollow at several heights above the floor, lowest first.
std::vector<SetDown> ways_to(const Task& task, const ObjectState& object, const WorldSnapshot& world) {
  if (task.into.empty()) return set_downs(object, *task.p_WG, world, task.near_m);
  std::vector<SetDown> ways;
  // The hollow of a cup is 9 cm deep.
  for (const double above_m : {0.0, 0.01, 0.02, 0.035, 0.05, 0.07, 0.09})
    ways.push_back({*task.p_WG + Vec3(0, 0, above_m), std::nullopt});
  return ways;
}

/// The grip with each turn that suits the end of a way.
std::vector<Grip> turned_for(const Task& task, const Grip& grip, const ObjectState& object, const SetDown& way,
                             const WorldSnapshot& world, const AvatarForm& avatar) {
  if (task.on_end) return grips_on_end(grip, object, way.first_W(), world, avatar, task.into);
  return grips_at(grip, object, way.first_W(), world, avatar, task.into);
}

/// There is room for the task, judged without the arm.
bool has_room(const Task& task, const WorldSnapshot& world, const Means& means) {
  const ObjectState& object = *world.find(task.object);
  const auto grips = starts_of(task, world, means, std::nullopt);
  const auto fits = [](const Grip& grip) { return grip.conflict_m == 0; };
  if (!task.p_WG) return std::any_of(grips.begin(), grips.end(), fits);
  for (const SetDown& way : ways_to(task, object, world)) {
    for (const Grip& grip : grips) {
      if (!fits(grip)) continue;
      const auto turned = turned_for(task, grip, object, way, world, means.avatar);
      if (std::any_of(turned.begin(), turned.end(), fits)) return true;
    }
  }
  return false;
}

/// The world after an object and the things on it have moved.
WorldSnapshot moved(const WorldSnapshot& world, const ObjectState& object, const Vec3& by_W) {
  WorldSnapshot after = world;
  after.held.clear();
  const auto riders = standing_on(object, world);
  for (auto& other : after.objects) {
    if (other.name == object.name || std::find(riders.begin(), riders.end(), other.name) != riders.end())
      other.p_WO += by_W;
  }
  return after;
}

// Whether the grip is at the part and from the side that the task asks for.
bool is_wanted(const Grip& grip, const Task& task, const ObjectState& object, const ObjectShape* form) {
  constexpr double leaning_rad = 0.5;  // the hand comes from the side rather than from above
  const bool leans = std::abs(grip.hand.tilt) > leaning_rad;
  if (task.approach != Approach::any && leans != (task.approach == Approach::side)) return false;
  if (!task.only_parts) return true;
  const Box* part = form ? form->part(task.parts) : nullptr;
  if (!part) return false;
  const Vec3 p_O = Eigen::AngleAxisd(-object.yaw, Vec3::UnitZ()) * grip.p_OT;
  return (p_O.head<2>().array() >= part->min.head<2>().array()).all() &&
         (p_O.head<2>().array() <= part->max.head<2>().array()).all();
}

}  // namespace

bool alike(const Grip& a, const Grip& b) {
  constexpr double same_rad = 0.2;  // the hand comes from the same side
  return std::abs(a.hand.yaw - b.hand.yaw) < same_rad && std::abs(a.hand.tilt - b.hand.tilt) < same_rad &&
         std::abs(a.turn - b.turn) < same_rad;
}

std::vector<Grip> starts_of(const Task& task, const WorldSnapshot& world, const Means& means,
                            const std::optional<Grasp>& grasp) {
  const ObjectState& object = *world.find(task.object);
  if (!grasp) {
    const auto shape = means.shapes.find(object.name);
    const ObjectShape* form = shape == means.shapes.end() ? nullptr : &shape->second;
    auto grips = grips_on(object, world, means.avatar, form, task.parts);
    std::erase_if(grips, [&](const Grip& grip) { return !is_wanted(grip, task, object, form); });
    return grips;
  }
  Grip grip;
  grip.hand = turn_of(grasp->X_WT.R_WB);
  grip.p_OT = grasp->X_WT.p_WB - object.p_WO;
  grip.opening_m = grasp->opening_m;
  return {grip};
}

std::optional<Handling> plan_handling(const Task& task, const WorldSnapshot& world, const Means& means,
                                      const std::optional<Grasp>& grasp, const std::vector<Grip>& tried) {
  const ObjectState& object = *world.find(task.object);
  const auto starts = starts_of(task, world, means, grasp);
  if (starts.empty()) return std::nullopt;
  Reach reach(means.avatar, object, world);

  Handling best;
  best.object = task.object;
  double best_conflict_m = 0;
  int tries = 0;
  const auto consider = [&](std::vector<Grip> grips, const std::optional<SetDown>& way) {
    for (Grip& grip : grips) {
      for (const Grip& before : tried) grip.cost += alike(grip, before) ? tried_cost : 0;
    }
    std::stable_sort(grips.begin(), grips.end(), [](const Grip& a, const Grip& b) {
      return std::pair(a.conflict_m, a.cost) < std::pair(b.conflict_m, b.cost);
    });
    for (const Grip& grip : grips) {
      // A grip with a conflict counts only if there is no better one, and only so many are tried.
      constexpr int most_tries = 150;  // each costs some solutions of the inverse kinematics
      if (best.reached && grip.conflict_m >= best_conflict_m) break;
      if (++tries > most_tries) break;
      bool free = true;
      bool reached = grasp || reach.reaches(hand_at(grip, object.p_WO, false), free);
      const Vec3 raised = object.p_WO + Vec3(0, 0, task.raise_m);
      if (reached && way) reached = reach.reaches(hand_at(grip, way->first_W(), true), free);
      if (reached && !way && task.raise_m > 0) reached = reach.reaches(hand_at(grip, raised, false), free);
      constexpr double arm_conflict_m = 0.02;  // an arm in the way outweighs a hand that grazes something
      const double conflict_m = std::max(grip.conflict_m, free ? 0.0 : arm_conflict_m);
      if (!reached || (best.reached && conflict_m >= best_conflict_m)) continue;
      best = {task.object, grip, way, task.into, task.on_end, conflict_m == 0, true};
      best_conflict_m = conflict_m;
      if (conflict_m == 0) return;
    }
  };

  if (!task.p_WG) {
    consider(starts, std::nullopt);
    return best;
  }
  auto ways = ways_to(task, object, world);
  const bool near_goal = !ways.empty();
  if (!near_goal) ways.push_back(elsewhere(task, object, world));
  for (const SetDown& way : ways) {
    std::vector<Grip> grips;
    for (const Grip& start : starts) {
      // A start without room is tried with the first way only: other ways are no better for it.
      if (start.conflict_m > 0 && best.reached) continue;
      const auto turned = turned_for(task, start, object, way, world, means.avatar);
      grips.insert(grips.end(), turned.begin(), turned.end());
    }
    consider(std::move(grips), way);
    if (best.has_room) break;
  }
  best.has_room = best.has_room && near_goal;
  return best;
}

std::optional<Handling> set_aside(const std::string& held, const WorldSnapshot& world, const Means& means,
                                  const Grasp& grasp) {
  constexpr double step_m = 0.02, nearby_m = 0.3;
  const ObjectState& object = *world.find(held);
  Vec3 below = object.p_WO;
  below.z() = world.table.max.z() + object.half_extents_m.z();
  auto places = free_places(object, below, world, nearby_m, step_m);
  if (is_free(object, below, world)) places.insert(places.begin(), below);
  for (const Vec3& place : places) {
    const auto handling = plan_handling({held, {}, place}, world, means, grasp, {});
    if (handling && handling->has_room) return handling;
  }
  return std::nullopt;
}

std::optional<Handling> make_room(const Task& task, const WorldSnapshot& world, const Means& means,
                                  const std::optional<Grasp>& grasp) {
  const ObjectState& object = *world.find(task.object);
  constexpr double step_m = 0.02, nearby_m = 0.2;
  constexpr double hinders_m = nearby_m / 1.5;  // a hand's length: farther things do not hinder

  // The held object is set down, to be grasped in another way.
  if (grasp) {
    ObjectState lying = object;
    lying.p_WO.z() = world.table.max.z() + object.half_extents_m.z();
    for (const Vec3& place : free_places(object, lying.p_WO, world, nearby_m, step_m)) {
      const Task aside{task.object, {}, place};
      const auto handling = plan_handling(aside, world, means, grasp, {});
      if (handling && handling->has_room && has_room(task, moved(world, object, place - object.p_WO), means))
        return handling;
    }
    return std::nullopt;
  }

  struct Shift {
    double by_m = 0;
    const ObjectState* other = nullptr;
    Vec3 by_W = Vec3::Zero();
  };
  std::vector<Shift> shifts;
  for (const ObjectState* other : apart_from(object, world)) {
    const auto riders = standing_on(*other, world);
    const auto bears = [&](const std::string& name) {
      return std::find(riders.begin(), riders.end(), name) != riders.end();
    };
    const double away_m = std::min((other->p_WO - object.p_WO).head<2>().norm(),
                                   task.p_WG ? (other->p_WO - *task.p_WG).head<2>().norm() : nearby_m);
    if (other->name == task.landmark || bears(task.landmark) || bears(task.object) || away_m > hinders_m) continue;
    constexpr int directions = 8;
    // From the room for one finger to the room for a hand.
    for (const double by_m : {0.012, 0.02, 0.03, 0.05, 0.08, 0.12}) {
      for (int i = 0; i < directions; ++i) {
        const double angle = full_turn * i / directions;
        shifts.push_back({by_m, other, by_m * Vec3(std::cos(angle), std::sin(angle), 0)});
      }
    }
  }
  std::stable_sort(shifts.begin(), shifts.end(), [](const Shift& a, const Shift& b) { return a.by_m < b.by_m; });
  for (const Shift& shift : shifts) {
    if (!is_free(*shift.other, shift.other->p_WO + shift.by_W, world)) continue;
    if (!has_room(task, moved(world, *shift.other, shift.by_W), means)) continue;
    const Task aside{shift.other->name, {}, shift.other->p_WO + shift.by_W};
    const auto handling = plan_handling(aside, world, means, std::nullopt, {});
    if (handling && handling->has_room) return handling;
  }
  return std::nullopt;
}

}  // namespace continua
