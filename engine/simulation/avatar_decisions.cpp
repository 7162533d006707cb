#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "simulation/avatar.h"
#include "simulation/hand_route.h"
#include "simulation/stacks.h"
#include "simulation/turning.h"

namespace continua {

namespace {

using Status = ActReport::Status;

constexpr double room_within_m = 0.012;  // how far from its place a thing may be set down to find room
constexpr double standing_m = 0.005;     // no farther above what is below it a thing stands
constexpr int most_preparations = 4, most_pushes = 8;

/// The object is carried to a goal.
bool is_carried(Capability what) { return moves_to_goal(what) && what != Capability::push; }

}  // namespace

/// Ends the act before anything is moved; what has failed before remains the reason of the failure.
void Avatar::cannot(Status status, std::string reason) {
  if (outcome_.status == Status::done) outcome_ = {0, {}, status, 0, std::move(reason)};
  end_act();
}

/// Counts what has failed before, if anything has, as an attempt.
void Avatar::begin_attempt() {
  if (outcome_.status == Status::done) return;
  ++(outcome_.status == Status::unreachable ? detours_ : retried_);
  pushes_ = 0;
  retries_.push_back(outcome_.reason);
  outcome_ = {};
}

/// Sets out the phases, or ends the act if it cannot be done.
void Avatar::decide() {
  const WorldSnapshot world = physics_.snapshot({});
  phases_.clear();
  failing_ = false;
  stage_ = Stage::act;
  if (const auto name = missing_thing(command_, world))
    return cannot(Status::unreachable, fmt::format("there is no '{}'", *name));
  if (has_goal() && !command_.object.empty()) {
    const auto place = placement(command_, world, Occupied::cleared);
    if (!place) return cannot(Status::blocked, place.error().sentence);
  }

  if (is_gesture(command_.what)) {
    if (!find_ik(physics_.arm(), gesture_pose(world)).reached)
      return cannot(Status::unreachable, "that place is out of my reach");
    phases_ = {Phase::hover};
  } else if (command_.what == Capability::ungrasp) {
    object_ = physics_.held();
    if (object_ >= 0) phases_ = {Phase::lower, Phase::open, Phase::retreat, Phase::settle};
  } else if (command_.object.empty()) {
    return cannot(Status::blocked, "there is nothing in the hand");
  } else if (!world.held.empty() && (world.held != command_.object || command_.what == Capability::push)) {
    // What is in the hand is put away before it is decided how to go about the other object.
    return put_away(world);
  } else if (command_.what == Capability::push) {
    return decide_push(world);
  } else if (command_.what == Capability::turn) {
    return decide_turn(world);
  } else {
    return decide_handling(world);
  }
  begin_phase();
}

/// Sets down what is in the hand: below, or where there is room nearby.
void Avatar::put_away(const WorldSnapshot& world) {
  stage_ = Stage::preparation;
  const ObjectState& held = *world.find(world.held);
  const bool stands = held.bounds_W().min.z() - height_under(held, world) < standing_m;
  const auto handling = stands ? std::nullopt : set_aside(world.held, world, means_, *grasp());
  if (handling) return begin_handling(*handling, true);
  phases_ = {Phase::lower, Phase::open, Phase::retreat};
  begin_phase();
}

std::optional<Grasp> Avatar::grasp() const {
  if (physics_.held() < 0) return std::nullopt;
  return Grasp{tool_pose(physics_.arm(), physics_.hinges()), release_opening_m_};
}

/// Whether it matters where the object shall go.
bool Avatar::has_goal() const {
  return is_carried(command_.what) || (command_.what == Capability::grasp && command_.next);
}

std::string Avatar::landmark() const {
  return command_.goal.landmarks.empty() ? std::string() : command_.goal.landmarks.front();
}

Task Avatar::task(const WorldSnapshot& now) const {
  // What is put somewhere comes to lie along the world's axes: its place is one for a thing that lies so.
  WorldSnapshot world = now;
  for (auto& object : world.objects)
    if (has_goal() && object.name == command_.object) object.yaw = straightened(object.yaw);

  Task task;
  task.object = command_.object;
  task.parts = command_.parts;
  if (has_goal()) {
    Placement place = placement(command_, world, Occupied::cleared).value();
    if (command_.goal.relation && is_side(*command_.goal.relation) &&
        !is_free(*world.find(command_.object), place.p_WO, world)) {
      // There may be room a little farther on the same side.
      const auto free = placement(command_, world, Occupied::avoided);
      if (free) place = *free;
    }
    task.p_WG = place.p_WO;
    task.near_m = room_within_m;
    task.landmark = landmark();
    if (command_.goal.relation == Relation::in) task.into = task.landmark;
    task.on_end = place.upright;
  }
  if (command_.what == Capability::lift) task.raise_m = command_.height_m;
  return task;
}

void Avatar::decide_handling(const WorldSnapshot& world) {
  const Task wanted = task(world);
  const ObjectState& object = *world.find(wanted.object);
  p_WG_ = wanted.p_WG.value_or(object.p_WO + Vec3(0, 0, wanted.raise_m));
  const AvatarForm& avatar = physics_.avatar();
  const auto reaches = [&](const Vec3& p_WO) {
    return find_ik(avatar.arm, {p_WO, rotation({avatar.natural_yaw(p_WO), 0})}).reached;
  };
  const bool in_hand = world.held == wanted.object;
  const auto held = in_hand ? grasp() : std::nullopt;
  const auto handling = plan_handling(wanted, world, means_, held, tried_);
  if (!handling) return cannot(Status::blocked, fmt::format("{} is too wide for the hand", object.name));
  if (!handling->reached || !reaches(p_WG_)) {
    return cannot(Status::unreachable, in_hand || reaches(object.p_WO)
                                           ? "that place is out of my reach"
                                           : fmt::format("{} is out of my reach", object.name));
  }
  begin_attempt();
  yaw_WG_.reset();
  if (handling->set_down && !handling->on_end) yaw_WG_ = object.yaw + handling->grip.turn;
  if (!handling->has_room && preparations_ < most_preparations) {
    if (const auto aside = make_room(wanted, world, means_, held)) {
      ++preparations_;
      stage_ = Stage::preparation;
      if (aside->object != wanted.object) moved_aside_.push_back(aside->object);
      return begin_handling(*aside, world.held == aside->object);
    }
  }
  begin_handling(*handling, in_hand);
}

/// About the vertical, where it is; by halves with a new grasp between them if the wrist cannot turn as far at once.
void Avatar::decide_turn(const WorldSnapshot& world) {
  constexpr double quarter_turn = 1.5707963267948966;
  const ObjectState& object = *world.find(command_.object);
  if (!yaw_WG_) yaw_WG_ = object.yaw + std::remainder(command_.turn_rad, 4 * quarter_turn);
  p_WG_ = object.p_WO;
  const bool in_hand = world.held == object.name;
  const double by_rad = std::remainder(*yaw_WG_ - object.yaw, 4 * quarter_turn);
  const auto held = in_hand ? grasp() : std::nullopt;
  const bool may_prepare = preparations_ < most_preparations;
  Task what;
  what.object = command_.object;
  what.parts = command_.parts;
  auto handling = plan_turn(what, by_rad, world, means_, held, tried_);
  if (!handling) return cannot(Status::blocked, fmt::format("{} is too wide for the hand", object.name));
  if ((!handling->reached || !handling->has_room) && in_hand && may_prepare) {
    ++preparations_;
    return put_away(world);
  }
  bool halfway = false;
  if (!handling->reached && !in_hand && may_prepare) {
    handling = plan_turn(what, by_rad / 2, world, means_, held, tried_);
    halfway = true;
  }
  if (!handling->reached) return cannot(Status::unreachable, fmt::format("the arm cannot turn {} there", object.name));
  if (!handling->has_room) return cannot(Status::blocked, fmt::format("there is no room to turn {}", object.name));
  begin_attempt();
  preparations_ += halfway;
  stage_ = halfway ? Stage::preparation : Stage::act;
  begin_handling(*handling, in_hand);
}

/// Push by push, each decided by where the object has come to be.
void Avatar::decide_push(const WorldSnapshot& world) {
  const ObjectState& object = *world.find(command_.object);
  object_ = index_of(object.name);
  if (!yaw_WG_) {
    const auto place = placement(command_, world, command_.goal.relation ? Occupied::avoided : Occupied::cleared);
    if (!place) return cannot(Status::blocked, place.error().sentence);
    p_WG_ = place->p_WO;
    yaw_WG_ = object.yaw;
  }
  begin_attempt();
  if (pushes_ >= most_pushes || !needs_push(object, p_WG_, means_)) {
    phases_ = {Phase::settle};
    return begin_phase();
  }
  const auto push = plan_push(object, p_WG_, landmark(), world, means_);
  if (!push) {
    // As near as it can be brought, if that is near enough.
    if (pushes_ > 0 && (p_WG_ - object.p_WO).head<2>().norm() <= set_down_error_m) {
      phases_ = {Phase::settle};
      return begin_phase();
    }
    return cannot(push.error().where.empty() ? Status::blocked : Status::unreachable, push.error().sentence);
  }
  // By how much the last push in this direction fell short, the next goes farther.
  const bool again = pushes_ > 0 && push->ahead_W.dot(push_.ahead_W) > 0.99;
  short_m_ = again ? short_m_ + (p_WG_ - object.p_WO).dot(push->ahead_W) : 0;
  ++pushes_;
  push_ = *push;
  push_.end_X_WT.p_WB += short_m_ * push_.ahead_W;
  stage_ = Stage::preparation;
  phases_ = {Phase::behind, Phase::push, Phase::back_off};
  begin_phase();
}

void Avatar::begin_handling(const Handling& handling, bool in_hand) {
  handling_ = handling;
  let_go_.reset();
  object_ = index_of(handling.object);
  if (!in_hand) phases_ = {Phase::approach, Phase::close};
  const bool preparing = stage_ == Stage::preparation;
  const bool turning = command_.what == Capability::turn;
  if (handling.set_down && (preparing || turning || is_carried(command_.what))) {
    const WorldSnapshot world = physics_.snapshot({});
    const ObjectState& object = *world.find(handling.object);
    const bool in_the_air = object.bounds_W().min.z() - height_under(object, world) > standing_m;
    phases_.push_back(Phase::carry);
    if (!turning || preparing || !in_the_air) phases_.push_back(handling.into.empty() ? Phase::lower : Phase::insert);
    if (handling.set_down->shove_from_W) phases_.push_back(Phase::shove);
    if (preparing || lets_go_) phases_.insert(phases_.end(), {Phase::open, Phase::retreat, Phase::settle});
  } else if (command_.what == Capability::lift) {
    phases_.push_back(Phase::raise);
  }
  begin_phase();
}

}  // namespace continua
