#include "continua/simulation/feasibility.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "continua/body/placement.h"
#include "continua/core/angles.h"
#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/turning.h"

namespace continua {

namespace {

using Code = ReasonCode;

constexpr double room_within_m = 0.012;  // an object may be set down this far from its place to find room

std::string landmark_of(const Goal& goal) { return goal.landmarks.empty() ? std::string() : goal.landmarks.front(); }

/// The scene's avatar, without a present grasp: the hold on an object in the hand is not known.
class ArmAbility : public Ability {
 public:
  ArmAbility(AvatarForm form, ObjectShapes shapes) : form_(std::move(form)), shapes_(std::move(shapes)) {}

  std::optional<Reason> hindrance(const AvatarCommand& asked, const WorldSnapshot& world) const override {
    const AvatarCommand command = with_next_goal(asked);
    // Pushes are not judged: they go on by several pushes, each from where the one before has ended.
    if (!needs_object(command.what) || to_goal(command.what) == ToGoal::pushed) return std::nullopt;
    const bool in_hand = world.held == command.object;
    if (command.what == Capability::turn) return in_hand ? std::nullopt : hindrance_to_turn(command, world);
    const auto task = task_of(command, world, form_);
    if (!task) return task.reason();
    // The grip was chosen for the goal.
    if (in_hand && task->p_WG && !hand_reaches(form_, *task->p_WG)) return Reason{Code::place_out_of_reach};
    if (in_hand) return std::nullopt;
    const auto handling = feasible_handling(*task, world, means(), std::nullopt, {});
    return handling ? std::nullopt : std::optional(handling.reason());
  }

  bool reaches(const Vec3& p_W) const override { return hand_reaches(form_, p_W); }

 private:
  Means means() const { return {form_, shapes_}; }

  std::optional<Reason> hindrance_to_turn(const AvatarCommand& command, const WorldSnapshot& world) const {
    Task task;
    task.object = command.object;
    task.parts = command.parts;
    const double by_rad = std::remainder(command.turn_rad, full_turn);
    auto handling = plan_turn(task, by_rad, world, means(), std::nullopt, {});
    if (!handling) return Reason{Code::too_wide, {command.object}};
    if (!handling->reached) handling = plan_turn(task, by_rad / 2, world, means(), std::nullopt, {});
    if (!handling->reached) return Reason{Code::no_turn, {command.object}};
    if (!handling->has_room) return Reason{Code::no_room_to_turn, {command.object}};
    return std::nullopt;
  }

  AvatarForm form_;
  ObjectShapes shapes_;
};

}  // namespace

bool hand_reaches(const AvatarForm& avatar, const Vec3& p_W) {
  return find_ik(avatar.arm, {p_W, rotation({avatar.natural_yaw(p_W), 0})}).has_value();
}

bool has_goal(const AvatarCommand& command) {
  return is_carried(command.what) || (command.what == Capability::grasp && command.next);
}

AvatarCommand with_next_goal(AvatarCommand command) {
  if (command.what == Capability::grasp && command.next) command.goal = *command.next;
  return command;
}

OrReason<Task> task_of(const AvatarCommand& command, const WorldSnapshot& now, const AvatarForm& avatar) {
  const Reaches reached = [&](const Vec3& p_W) { return hand_reaches(avatar, p_W); };
  // A carried object comes to lie along the world's axes, so its place is sought for an object that lies so.
  WorldSnapshot world = now;
  for (auto& object : world.objects)
    if (has_goal(command) && object.name == command.object) object.yaw = straightened(object.yaw);

  Task task;
  task.object = command.object;
  task.parts = command.parts;
  task.only_parts = command.only_parts;
  task.approach = command.approach;
  if (has_goal(command)) {
    auto place = placement(command, world, Occupied::cleared, reached);
    const bool may_be_farther = place && command.goal.relation && is_side(*command.goal.relation) &&
                                !is_free(*world.find(command.object), place->p_WO, world);
    // There may be room a little farther on the same side, or where nothing is moved out of the way.
    if (auto free = !place || may_be_farther ? placement(command, world, Occupied::avoided, reached) : place; free)
      place = std::move(free);
    if (!place) return place.reason();
    task.p_WG = place->p_WO;
    task.near_m = room_within_m;
    task.landmark = landmark_of(command.goal);
    if (command.goal.relation == Relation::in) task.into = task.landmark;
    task.on_end = place->upright;
  }
  if (command.what == Capability::lift) task.raise_m = command.height_m;
  return task;
}

Vec3 end_of(const Task& task, const WorldSnapshot& world) {
  return task.p_WG.value_or(world.find(task.object)->p_WO + Vec3(0, 0, task.raise_m));
}

OrReason<Handling> feasible_handling(const Task& task, const WorldSnapshot& world, const Means& means,
                                     const std::optional<Grasp>& grasp, const std::vector<Grip>& tried) {
  const ObjectState& object = *world.find(task.object);
  auto handling = plan_handling(task, world, means, grasp, tried);
  const bool particular = task.only_parts || task.approach != Approach::any;
  if (!handling) return Reason{particular ? Code::no_such_hold : Code::too_wide, {object.name}};
  // Without a goal the grip alone decides, as in a grasp before an act with a goal.
  if (handling->reached && (!task.p_WG || hand_reaches(means.avatar, *task.p_WG))) return *std::move(handling);
  if (particular && hand_reaches(means.avatar, object.p_WO)) return Reason{Code::no_such_hold, {object.name}};
  if (grasp || hand_reaches(means.avatar, object.p_WO)) return Reason{Code::place_out_of_reach};
  return Reason{Code::out_of_reach, {object.name}};
}

Result<std::shared_ptr<const Ability>> arm_ability(const Scene& scene) {
  auto avatar = find_avatar(scene.model(), scene.initial_qpos(), scene.path());
  if (!avatar) return avatar.error();
  ObjectShapes shapes;
  for (const auto& object : scene.objects()) shapes[object.name] = object.shape;
  return std::shared_ptr<const Ability>(std::make_shared<ArmAbility>(std::move(avatar->first), std::move(shapes)));
}

}  // namespace continua
