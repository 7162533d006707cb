#include "behaviour/kinematic_body.h"

#include <algorithm>

#include <fmt/format.h>

namespace continua {

namespace {

using Status = ActReport::Status;

// Things whose faces are this near touch.
constexpr double contact_m = 0.005;

/// Area in which two boxes overlap, seen from above.
double overlap_area(const Box& a, const Box& b) {
  const double x = std::min(a.max.x(), b.max.x()) - std::max(a.min.x(), b.min.x());
  const double y = std::min(a.max.y(), b.max.y()) - std::max(a.min.y(), b.min.y());
  return x > 0 && y > 0 ? x * y : 0;
}

/// Index of the object that bears `world.objects[i]`: of those it touches from above, the one it overlaps most. -1: the
/// table.
int support_of(std::size_t i, const WorldSnapshot& world) {
  const Box box = world.objects[i].bounds_W();
  int support = -1;
  double most = 0;
  for (std::size_t j = 0; j < world.objects.size(); ++j) {
    const Box below = world.objects[j].bounds_W();
    if (j == i || std::abs(box.min.z() - below.max.z()) > contact_m) continue;
    const double area = overlap_area(box, below);
    if (area > most) {
      most = area;
      support = static_cast<int>(j);
    }
  }
  return support;
}

bool moves_things(Capability what) {
  return what == Capability::grasp || what == Capability::lift || what == Capability::put || what == Capability::slide;
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
    if (now.p_WO == before.objects[i].p_WO) continue;
    moved.bodies[now.name] = {now.p_WO, Eigen::Quaterniond(Eigen::AngleAxisd(now.yaw, Vec3::UnitZ()))};
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

  const bool needs_landmark = (command.what == Capability::put || command.what == Capability::slide) &&
                              command.goal.relation != Goal::Relation::at;
  for (const auto& name : {command.object, needs_landmark ? command.goal.landmark : std::string()}) {
    if (!name.empty() && !world_.find(name)) return failed(Status::unreachable, fmt::format("there is no '{}'", name));
  }
  if (needs_landmark && (command.goal.landmark.empty() || command.goal.landmark == command.object))
    return failed(Status::blocked, "a goal beside or on something needs another object");
  if (command.what == Capability::ungrasp) {
    release();
    return end;
  }
  if (!moves_things(command.what)) return end;

  const std::string object = command.object.empty() ? world_.held : command.object;
  if (object.empty()) return failed(Status::blocked, "there is nothing to move");
  if (object != world_.held) release();
  world_.held = object;
  if (command.what == Capability::grasp) return end;

  if (command.what == Capability::lift) {
    shift(object, Vec3(0, 0, command.height_m));
    return end;
  }
  AvatarCommand moving = command;
  moving.object = object;
  shift(object, goal_position(moving, world_) - world_.find(object)->p_WO);
  world_.held.clear();
  return end;
}

void KinematicBody::shift(const std::string& object, const Vec3& by_W) {
  // Who moves is settled before anything does: what stands on something that moves, and so on up.
  std::vector<bool> moves(world_.objects.size(), false);
  std::vector<int> supports;
  for (std::size_t i = 0; i < world_.objects.size(); ++i) {
    supports.push_back(support_of(i, world_));
    moves[i] = world_.objects[i].name == object;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (moves[i] || supports[i] < 0 || !moves[static_cast<std::size_t>(supports[i])]) continue;
      moves[i] = changed = true;
    }
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i]) world_.objects[i].p_WO = on_grid(Vec3(world_.objects[i].p_WO + by_W));
  }
}

void KinematicBody::release() {
  const ObjectState* held = world_.find(world_.held);
  world_.held.clear();
  if (!held) return;
  const Box box = held->bounds_W();
  // It comes to stand on that whose footprint it overlaps most.
  double floor = world_.table.max.z(), most = 0;
  for (const auto& other : world_.objects) {
    const Box below = other.bounds_W();
    if (other.name == held->name || below.max.z() > box.min.z() + contact_m) continue;
    const double area = overlap_area(box, below);
    if (area < most || area == 0 || (area == most && below.max.z() < floor)) continue;
    most = area;
    floor = below.max.z();
  }
  shift(held->name, Vec3(0, 0, floor - box.min.z()));
}

}  // namespace continua
