#include "behaviour/kinematic_body.h"

#include <algorithm>

#include <fmt/format.h>

#include "behaviour/standing.h"

namespace continua {

namespace {

using Status = ActReport::Status;

bool is_move(Capability what) {
  return what == Capability::put || what == Capability::slide || what == Capability::move;
}
bool needs_object(Capability what) { return what == Capability::grasp || what == Capability::lift || is_move(what); }

ObjectState& object_of(WorldSnapshot& world, std::string_view name) {
  const auto found = std::find_if(world.objects.begin(), world.objects.end(),
                                  [&](const ObjectState& one) { return one.name == name; });
  require(found != world.objects.end(), "an object of the world has a place in it");
  return *found;
}

/// How an object is turned that lay like `lying` and may stand on its end now.
Eigen::Quaterniond turn_of(const ObjectState& now, const ObjectState* lying) {
  const Eigen::Quaterniond yaw(Eigen::AngleAxisd(now.yaw, Vec3::UnitZ()));
  if (!lying) return yaw;
  constexpr double quarter_turn = 1.5707963267948966;
  const bool x_upright = lying->half_extents_m.x() >= lying->half_extents_m.y();
  return yaw * Eigen::AngleAxisd(quarter_turn, x_upright ? Vec3::UnitY() : Vec3(-Vec3::UnitX()));
}

}  // namespace

WorldReport KinematicBody::advance(SimTime t) {
  WorldReport report;
  report.until = waiting_.empty() ? std::max(world_.t, t) : world_.t;
  world_.t = report.until;
  const WorldSnapshot before = world_;
  const auto is_stop = [](const AvatarCommand& command) { return command.what == Capability::stop; };
  const auto last_stop = std::find_if(waiting_.rbegin(), waiting_.rend(), is_stop).base();  // after it
  for (auto it = waiting_.begin(); it != waiting_.end(); ++it) {
    if (it + 1 < last_stop && it->what != Capability::look && it->what != Capability::signal) {
      report.acts.push_back({it->id, world_.t, Status::stopped, 0, ""});
      continue;
    }
    report.acts.push_back({it->id, world_.t, Status::started, 0, ""});
    ActReport end = act(*it);
    end.id = it->id;
    end.t = world_.t;
    report.acts.push_back(std::move(end));
  }
  waiting_.clear();

  PoseSample moved{world_.t, {}};
  for (std::size_t i = 0; i < world_.objects.size(); ++i) {
    const ObjectState& now = world_.objects[i];
    if (now.p_WO == before.objects[i].p_WO && now.half_extents_m == before.objects[i].half_extents_m) continue;
    const auto lying = lying_.find(now.name);
    moved.bodies[now.name] = {now.p_WO, turn_of(now, lying == lying_.end() ? nullptr : &lying->second)};
  }
  if (!moved.bodies.empty()) report.poses.push_back(std::move(moved));
  return report;
}

ActReport KinematicBody::act(const AvatarCommand& command) {
  ActReport end;
  const auto failed = [&](Status status, std::string reason) {
    end.status = status;
    end.reason = std::move(reason);
    return end;
  };

  if (const auto name = missing_thing(command, world_))
    return failed(Status::unreachable, fmt::format("there is no '{}'", *name));
  if (command.what == Capability::ungrasp) {
    release();
    return end;
  }
  if (!needs_object(command.what)) return end;

  AvatarCommand handling = command;
  if (handling.object.empty()) handling.object = world_.held;
  if (handling.object.empty()) return failed(Status::blocked, "there is nothing to move");
  const bool in_hand = handling.object == world_.held;
  if (command.what == Capability::move && !in_hand)
    return failed(Status::blocked, fmt::format("{} is not in the hand", handling.object));
  const WorldSnapshot before = world_;
  if (!in_hand) release();
  if (is_move(command.what)) {
    end = move(handling);
    if (end.status != Status::done) world_ = before;
    if (end.status == Status::done && (command.what == Capability::put || !in_hand)) world_.held.clear();
    return end;
  }
  if (command.what == Capability::grasp && command.next && !in_hand) {
    handling.goal = *command.next;
    const auto place = placement(handling, lying_down(handling.object), Occupied::avoided);
    if (!place) {
      world_ = before;
      return failed(Status::blocked, place.error().sentence);
    }
  }
  world_.held = handling.object;
  if (command.what == Capability::lift) shift(handling.object, Vec3(0, 0, command.height_m));
  return end;
}

ActReport KinematicBody::move(const AvatarCommand& command) {
  ActReport end;
  const WorldSnapshot laid = lying_down(command.object);
  const auto place = placement(command, laid, Occupied::avoided);
  if (!place) {
    end.status = Status::blocked;
    end.reason = place.error().sentence;
    return end;
  }
  shift(command.object, place->p_WO - world_.find(command.object)->p_WO);
  ObjectState& object = object_of(world_, command.object);
  const ObjectState lying = *laid.find(command.object);
  const ObjectState shaped = place->upright ? stood_on_end(lying) : lying;
  object.half_extents_m = shaped.half_extents_m;
  object.interior = shaped.interior;
  lying_.erase(command.object);
  if (place->upright) {
    lying_.emplace(command.object, lying);
    end.reason = fmt::format("{} stands on its end", command.object);
  }
  return end;
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
  // Who moves is settled before anything does.
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
