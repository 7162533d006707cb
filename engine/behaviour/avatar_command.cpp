#include "behaviour/avatar_command.h"

#include <algorithm>

#include "core/result.h"

namespace continua {

std::string text(Capability what) {
  switch (what) {
    case Capability::reach:
      return "reach";
    case Capability::point:
      return "point";
    case Capability::look:
      return "look";
    case Capability::grasp:
      return "grasp";
    case Capability::lift:
      return "lift";
    case Capability::put:
      return "put";
    case Capability::slide:
      return "slide";
    case Capability::ungrasp:
      return "ungrasp";
    case Capability::signal:
      return "signal";
  }
  return "";
}

std::string text(ActReport::Status status) {
  switch (status) {
    case ActReport::Status::started:
      return "started";
    case ActReport::Status::done:
      return "done";
    case ActReport::Status::missed:
      return "missed";
    case ActReport::Status::dropped:
      return "dropped";
    case ActReport::Status::blocked:
      return "blocked";
    case ActReport::Status::unreachable:
      return "unreachable";
  }
  return "";
}

std::string text(Goal::Relation relation) {
  switch (relation) {
    case Goal::Relation::at:
      return "at";
    case Goal::Relation::on:
      return "on";
    case Goal::Relation::left_of:
      return "left_of";
    case Goal::Relation::right_of:
      return "right_of";
    case Goal::Relation::in_front_of:
      return "in_front_of";
    case Goal::Relation::behind:
      return "behind";
  }
  return "";
}

namespace {

/// What an object beside `landmark` comes to stand on: the table, or things that are no higher than what the landmark
/// itself stands on.
double support_height(const Vec3& p_W, double landmark_bottom, const ObjectState& object, const ObjectState& landmark,
                      const WorldSnapshot& world) {
  constexpr double slack_m = 0.01;
  double height = world.table.max.z();
  for (const auto& other : world.objects) {
    if (other.name == object.name || other.name == landmark.name) continue;
    const Box box = other.bounds_W();
    const bool under = p_W.x() > box.min.x() && p_W.x() < box.max.x() && p_W.y() > box.min.y() && p_W.y() < box.max.y();
    if (under && box.max.z() <= landmark_bottom + slack_m) height = std::max(height, box.max.z());
  }
  return height;
}

}  // namespace

Vec3 goal_position(const AvatarCommand& command, const WorldSnapshot& world) {
  const ObjectState* object = world.find(command.object);
  require(object, "a goal is asked for an object that is not in the world");
  const Vec3 half = object->half_extents_m;
  if (command.goal.relation == Goal::Relation::at)
    return on_grid(Vec3(command.goal.p_WG.x(), command.goal.p_WG.y(), world.table.max.z() + half.z()));

  const ObjectState* landmark = world.find(command.goal.landmark);
  require(landmark, "a goal is asked beside a landmark that is not in the world");
  // Extents along the world's axes: an object may be turned.
  const Vec3 gap =
      (object->bounds_W().max - object->bounds_W().min + landmark->bounds_W().max - landmark->bounds_W().min) / 2;
  Vec3 p = landmark->p_WO;
  switch (command.goal.relation) {
    case Goal::Relation::left_of:
      p.x() += gap.x();
      break;
    case Goal::Relation::right_of:
      p.x() -= gap.x();
      break;
    case Goal::Relation::in_front_of:
      p.y() += gap.y();
      break;
    case Goal::Relation::behind:
      p.y() -= gap.y();
      break;
    default:
      p.z() = landmark->bounds_W().max.z() + half.z();
      return on_grid(p);
  }
  p.z() = support_height(p, landmark->bounds_W().min.z(), *object, *landmark, world) + half.z();
  return on_grid(p);
}

}  // namespace continua
