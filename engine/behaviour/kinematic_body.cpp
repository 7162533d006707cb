#include "behaviour/kinematic_body.h"

#include <algorithm>

#include <fmt/format.h>

#include "behaviour/standing.h"

namespace continua {

namespace {

using Status = ActReport::Status;

bool is_move(Capability what) { return what == Capability::put || what == Capability::slide; }
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
  world_.t = t;
  const WorldSnapshot before = world_;
  for (const auto& command : waiting_) {
    report.acts.push_back({command.id, t, Status::started, 0, ""});
    ActReport end = act(command);
    end.id = command.id;
    end.t = t;
    report.acts.push_back(std::move(end));
  }
  waiting_.clear();

  PoseSample moved{t, {}};
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
  const WorldSnapshot before = world_;
  if (handling.object != world_.held) release();
  if (is_move(command.what)) {
    end = move(handling);
    if (end.status != Status::done) world_ = before;
    return end;
  }
  world_.held = handling.object;
  if (command.what == Capability::lift) shift(handling.object, Vec3(0, 0, command.height_m));
  return end;
}

ActReport KinematicBody::move(const AvatarCommand& command) {
  ActReport end;
  const auto stood = lying_.find(command.object);
  WorldSnapshot laid = world_;
  if (stood != lying_.end()) {
    ObjectState& object = object_of(laid, command.object);
    object.half_extents_m = stood->second.half_extents_m;
    object.interior = stood->second.interior;
  }
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
  world_.held.clear();
  return end;
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
