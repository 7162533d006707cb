#include "continua/body/kinematic_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "continua/body/push_apart.h"
#include "continua/body/standing.h"
#include "continua/core/angles.h"

namespace continua {

namespace {

using Status = ActReport::Status;

ObjectState& object_of(WorldSnapshot& world, std::string_view name) {
  const auto found = std::find_if(world.objects.begin(), world.objects.end(),
                                  [&](const ObjectState& one) { return one.name == name; });
  require(found != world.objects.end(), "an object of the world has a place in it");
  return *found;
}

/// Orientation of an object that stands on its end if it lay like `lying` before; `lying` may be null.
Eigen::Quaterniond turn_of(const ObjectState& now, const ObjectState* lying) {
  const Eigen::Quaterniond yaw(Eigen::AngleAxisd(now.yaw, Vec3::UnitZ()));
  if (!lying) return yaw;
  const bool x_upright = lying->half_extents_m.x() >= lying->half_extents_m.y();
  return yaw * Eigen::AngleAxisd(quarter_turn, x_upright ? Vec3::UnitY() : Vec3(-Vec3::UnitX()));
}

/// Names of the objects that an object touches, and `table`.
std::vector<std::string> touched_by(const ObjectState& object, const WorldSnapshot& world) {
  std::vector<std::string> touched;
  for (const auto& other : world.objects) {
    if (other.name == object.name) continue;
    const Vec3 depth = depth_of(object.bounds_W(), other.bounds_W());
    // A face has to touch; an edge is not enough.
    const bool faces = (depth.array() > touching_m).count() >= 2;
    if (faces && depth.minCoeff() > -touching_m) touched.push_back(other.name);
  }
  if (object.bounds_W().min.z() < world.table.max.z() + touching_m) touched.emplace_back("table");
  std::sort(touched.begin(), touched.end());
  return touched;
}

/// A thing that the table bore before and no longer bears; nullptr if there is none.
const ObjectState* fallen(const WorldSnapshot& now, const WorldSnapshot& before) {
  const auto found = std::find_if(now.objects.begin(), now.objects.end(), [&](const ObjectState& each) {
    return bears(now.table, before.find(each.name)->p_WO) && !bears(now.table, each.p_WO);
  });
  return found == now.objects.end() ? nullptr : &*found;
}

bool is_stop(const AvatarCommand& command) { return command.what == Capability::stop; }

bool handles_things(const AvatarCommand& command) {
  return needs_object(command.what) || command.what == Capability::ungrasp;
}

}  // namespace

WorldReport KinematicBody::advance(SimTime t) {
  WorldReport report;
  const bool waits = this->waits();
  report.until = waits ? std::max(world_.t, t) : world_.t;
  world_.t = report.until;
  if (waits) return report;
  const WorldSnapshot before = world_;
  give_up_stopped(report);
  while (!waiting_.empty()) {
    const AvatarCommand command = waiting_.front();
    auto outcome = std::exchange(begun_, std::nullopt);
    if (!outcome) {
      report.acts.push_back({command.id, world_.t, Status::started, 0, {}});
      outcome = tried(command);
      // As in MuJoCo's world, an act begins before it has changed anything.
      if (handles_things(command) && outcome->end.status == Status::done) {
        begun_ = std::move(outcome);
        break;
      }
    }
    waiting_.pop_front();
    const std::string held = world_.held;
    ActReport end = std::move(outcome->end);
    world_ = std::move(outcome->world);
    world_.t = report.until;
    lying_ = std::move(outcome->lying);
    end.id = command.id;
    end.t = world_.t;
    const ObjectState* object = world_.find(command.object.empty() ? held : command.object);
    if (object && handles_things(command)) end.touches = touched_by(*object, world_);
    report.acts.push_back(std::move(end));
  }

  auto moved = moved_since(before);
  if (!moved.bodies.empty()) report.poses.push_back(std::move(moved));
  return report;
}

bool KinematicBody::waits() const {
  return waiting_.empty() || (held_ && begun_ && std::none_of(waiting_.begin(), waiting_.end(), is_stop));
}

void KinematicBody::give_up_stopped(WorldReport& report) {
  const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(), is_stop);
  if (last == waiting_.rend()) return;
  std::deque<AvatarCommand> kept;
  for (auto each = waiting_.begin(); each != last.base() - 1; ++each)
    if (effect_of(each->what) == ActEffect::announced)
      kept.push_back(*each);
    else
      report.acts.push_back({each->id, world_.t, Status::stopped, 0, {}});
  kept.insert(kept.end(), last.base() - 1, waiting_.end());
  waiting_ = std::move(kept);
  begun_.reset();
}

KinematicBody::Tried KinematicBody::tried(const AvatarCommand& command) const {
  KinematicBody trial(world_, occupied_, ability_);
  trial.lying_ = lying_;
  auto end = trial.act(command);
  return {std::move(end), std::move(trial.world_), std::move(trial.lying_)};
}

PoseSample KinematicBody::become(const KinematicBody& other) {
  const WorldSnapshot before = std::move(world_);
  world_ = other.world_;
  world_.t = before.t;
  lying_ = other.lying_;
  waiting_.clear();
  begun_.reset();
  return moved_since(before);
}

PoseSample KinematicBody::moved_since(const WorldSnapshot& before) const {
  PoseSample moved{world_.t, {}};
  for (std::size_t i = 0; i < world_.objects.size(); ++i) {
    const ObjectState& now = world_.objects[i];
    const ObjectState& then = before.objects[i];
    if (now.p_WO == then.p_WO && now.half_extents_m == then.half_extents_m && now.yaw == then.yaw) continue;
    const auto lying = lying_.find(now.name);
    moved.bodies[now.name] = {now.p_WO, turn_of(now, lying == lying_.end() ? nullptr : &lying->second)};
  }
  return moved;
}

ActReport KinematicBody::act(const AvatarCommand& command) {
  ActReport end;
  const auto failed = [&](Reason why) {
    end.end_for(std::move(why));
    return end;
  };

  if (const auto name = missing_thing(command, world_)) return failed({ReasonCode::missing, {*name}});
  if (command.what == Capability::ungrasp) {
    release();
    return end;
  }
  if (!needs_object(command.what)) return end;

  AvatarCommand handling = command;
  if (handling.object.empty()) handling.object = world_.held;
  if (handling.object.empty()) return failed({ReasonCode::nothing_held});
  const bool in_hand = handling.object == world_.held;
  if (command.what == Capability::move && !in_hand) return failed({ReasonCode::not_held, {handling.object}});
  const WorldSnapshot before = world_;
  if (!in_hand) release();
  if (auto why = hindrance(handling)) {
    world_ = before;
    return failed(*std::move(why));
  }
  if (command.what == Capability::turn) {
    if (const auto why = turn(handling)) {
      world_ = before;
      return failed(*why);
    }
    return end;
  }
  if (moves_to_goal(command.what)) {
    const auto lying_before = lying_;
    end = move(handling);
    if (end.status != Status::done) {
      world_ = before;
      lying_ = lying_before;
    }
    if (end.status == Status::done && empties_hand(command.what, in_hand)) world_.held.clear();
    return end;
  }
  world_.held = handling.object;
  if (command.what == Capability::lift) shift(handling.object, Vec3(0, 0, command.height_m));
  return end;
}

/// The reason why there is no place for the act's goal, or why the arm cannot do the act.
std::optional<Reason> KinematicBody::hindrance(const AvatarCommand& asked) const {
  AvatarCommand command = asked;
  const bool before_next = command.what == Capability::grasp && command.next;
  if (before_next && command.object == world_.held) return std::nullopt;
  if (before_next) command.goal = *command.next;
  const WorldSnapshot laid = lying_down(command.object);
  if (before_next || moves_to_goal(command.what))
    if (const auto place = place_of(command, laid); !place) return place.reason();
  return ability_ ? ability_->hindrance(command, laid) : std::nullopt;
}

OrReason<Placement> KinematicBody::place_of(const AvatarCommand& command, const WorldSnapshot& world) const {
  if (!ability_) return placement(command, world, occupied_);
  return placement(command, world, occupied_, [&](const Vec3& p_W) { return ability_->reaches(p_W); });
}

ActReport KinematicBody::move(const AvatarCommand& command) {
  ActReport end;
  const WorldSnapshot laid = lying_down(command.object);
  const auto place = place_of(command, laid);
  if (!place) {
    end.end_for(place.reason());
    return end;
  }
  shift(command.object, place->p_WO - world_.find(command.object)->p_WO);
  ObjectState& object = object_of(world_, command.object);
  const ObjectState lying = *laid.find(command.object);
  const ObjectState shaped = place->upright ? stood_on_end(lying) : lying;
  object.half_extents_m = shaped.half_extents_m;
  object.interior = shaped.interior;
  lying_.erase(command.object);
  if (!command.goal.relation || occupied_ == Occupied::cleared) {
    const WorldSnapshot crowded = world_;
    if (occupied_ == Occupied::avoided) world_ = pushed_apart(crowded, command.object, GivesWay::others);
    if (occupied_ == Occupied::cleared || fallen(world_, laid)) world_ = pushed_apart(crowded, command.object);
  }
  if (const auto* other = fallen(world_, laid)) {
    end.end_for({ReasonCode::falls_off, {other->name}});
    return end;
  }
  if (place->upright) {
    lying_.emplace(command.object, lying);
    end.reason = {ReasonCode::stands_on_end, {command.object}};
  }
  return end;
}

/// Turns the object and everything on it, or returns the reason why not.
std::optional<Reason> KinematicBody::turn(const AvatarCommand& command) {
  const auto moves = carried_with(command.object, world_);
  const Vec3 axis_W = world_.find(command.object)->p_WO;
  const Eigen::AngleAxisd R(command.turn_rad, Vec3::UnitZ());
  WorldSnapshot turned = world_;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!moves[i]) continue;
    ObjectState& object = turned.objects[i];
    object.p_WO = on_grid(Vec3(axis_W + R * (object.p_WO - axis_W)));
    object.yaw = std::remainder(object.yaw + command.turn_rad, full_turn);
    for (std::size_t j = 0; j < moves.size(); ++j)
      if (!moves[j] && overlap(object, world_.objects[j]) && !overlap(world_.objects[i], world_.objects[j]))
        return Reason{ReasonCode::in_the_way, {world_.objects[j].name, command.object}};
  }
  world_ = std::move(turned);
  return std::nullopt;
}

WorldSnapshot KinematicBody::lying_down(const std::string& name) const {
  WorldSnapshot laid = world_;
  const auto stood = lying_.find(name);
  if (stood == lying_.end()) return laid;
  ObjectState& object = object_of(laid, name);
  object.half_extents_m = stood->second.half_extents_m;
  object.interior = stood->second.interior;
  return laid;
}

void KinematicBody::shift(const std::string& object, const Vec3& by_W) {
  // Supports are read before anything moves.
  const auto moves = carried_with(object, world_);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i]) world_.objects[i].p_WO = on_grid(Vec3(world_.objects[i].p_WO + by_W));
  }
}

void KinematicBody::release() {
  const ObjectState* held = world_.find(world_.held);
  world_.held.clear();
  if (held) shift(held->name, Vec3(0, 0, height_below(*held, world_) - held->bounds_W().min.z()));
}

}  // namespace continua
