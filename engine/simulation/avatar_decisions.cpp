#include <algorithm>
#include <cmath>

#include "continua/body/placement.h"
#include "continua/core/angles.h"
#include "continua/simulation/avatar.h"
#include "continua/simulation/feasibility.h"
#include "continua/simulation/hand_route.h"
#include "continua/simulation/stacks.h"
#include "continua/simulation/turning.h"

namespace continua {

namespace {

using Code = ReasonCode;
using Status = ActStatus;

constexpr double standing_m = 0.005;  // an object no farther above its support stands on it
// Handlings that make room, and pushes of one object: bounds against acts that never end.
constexpr int most_preparations = 4, most_pushes = 8;

}  // namespace

// Ends the act before anything is moved. An earlier failure remains its reason.
void Avatar::cannot(Reason reason) {
  ActReport& outcome = state_.act.outcome;
  if (outcome.status == Status::done) {
    outcome = {};
    outcome.end_for(std::move(reason));
  }
  end_act();
}

// Counts the previous failure, if any, as an attempt.
void Avatar::begin_attempt() {
  ActReport& outcome = state_.act.outcome;
  Attempts& attempts = state_.attempts;
  if (outcome.status == Status::done) return;
  ++(outcome.status == Status::unreachable ? attempts.detours : attempts.retried);
  attempts.pushes = 0;
  attempts.retries.push_back(outcome.reason);
  outcome = {};
}

// Decides on the phases, or ends the act if it is impossible.
void Avatar::decide() {
  const WorldSnapshot world = physics_.snapshot({});
  const AvatarCommand& command = state_.act.command;
  state_.run.phases.clear();
  state_.run.failing = false;
  state_.under_way.preparing = false;
  if (const auto name = missing_thing(command, world)) return cannot({Code::missing, {*name}});
  if (has_goal(command) && !command.object.empty()) {
    const auto place = placement(command, world, Occupied::cleared);
    if (!place) return cannot(place.reason());
  }

  if (is_gesture(command.what)) {
    if (!find_ik(physics_.arm(), gesture_pose(command, physics_, world))) return cannot({Code::place_out_of_reach});
    return begin_phases({Phase::hover});
  }
  if (command.what == Capability::ungrasp) {
    state_.under_way.object = physics_.held();
    if (physics_.held() < 0) return begin_phase();
    return begin_phases({Phase::lower, Phase::open, Phase::retreat, Phase::settle});
  }
  if (command.object.empty()) return cannot({Code::nothing_held});
  // The hand is emptied before a decision about another object.
  const bool pushing = to_goal(command.what) == ToGoal::pushed;
  if (!world.held.empty() && (world.held != command.object || pushing)) return put_away(world);
  if (pushing) return decide_push(world);
  if (command.what == Capability::turn) return decide_turn(world);
  decide_handling(world);
}

// Sets down the held object: below, or where there is room nearby.
void Avatar::put_away(const WorldSnapshot& world) {
  state_.under_way.preparing = true;
  const ObjectState& held = *world.find(world.held);
  const bool stands = held.bounds_W().min.z() - height_under(held, world) < standing_m;
  const auto handling = stands ? std::nullopt : set_aside(world.held, world, means_, *grasp());
  if (handling) return begin_handling(*handling, true);
  begin_phases({Phase::lower, Phase::open, Phase::retreat});
}

std::optional<Grasp> Avatar::grasp() const {
  if (physics_.held() < 0) return std::nullopt;
  return Grasp{tool_pose(physics_.arm(), physics_.hinges()), state_.motion.release_opening_m};
}

void Avatar::decide_handling(const WorldSnapshot& world) {
  AvatarAct& act = state_.act;
  const auto task = task_of(act.command, world, physics_.avatar());
  if (!task) return cannot(task.reason());
  const Task& wanted = *task;
  const ObjectState& object = *world.find(wanted.object);
  act.p_WG = end_of(wanted, world);
  const bool in_hand = world.held == wanted.object;
  const auto held = in_hand ? grasp() : std::nullopt;
  const auto handling = feasible_handling(wanted, world, means_, held, state_.attempts.tried);
  if (!handling) return cannot(handling.reason());
  begin_attempt();
  act.yaw_WG.reset();
  if (handling->set_down && !handling->on_end) act.yaw_WG = object.yaw + handling->grip.turn;
  if (!handling->has_room && state_.attempts.preparations < most_preparations) {
    if (const auto aside = make_room(wanted, world, means_, held)) {
      ++state_.attempts.preparations;
      state_.under_way.preparing = true;
      if (aside->object != wanted.object) act.moved_aside.push_back(aside->object);
      return begin_handling(*aside, world.held == aside->object);
    }
  }
  begin_handling(*handling, in_hand);
}

// Turns about the vertical, on the spot. If the wrist cannot turn that far, in two halves with a new grasp between.
void Avatar::decide_turn(const WorldSnapshot& world) {
  AvatarAct& act = state_.act;
  const ObjectState& object = *world.find(act.command.object);
  if (!act.yaw_WG) act.yaw_WG = object.yaw + std::remainder(act.command.turn_rad, 4 * quarter_turn);
  act.p_WG = object.p_WO;
  const bool in_hand = world.held == object.name;
  const double by_rad = std::remainder(*act.yaw_WG - object.yaw, 4 * quarter_turn);
  const auto held = in_hand ? grasp() : std::nullopt;
  Attempts& attempts = state_.attempts;
  const bool may_prepare = attempts.preparations < most_preparations;
  Task what;
  what.object = act.command.object;
  what.parts = act.command.parts;
  auto handling = plan_turn(what, by_rad, world, means_, held, attempts.tried);
  if (!handling) return cannot({Code::too_wide, {object.name}});
  if ((!handling->reached || !handling->has_room) && in_hand && may_prepare) {
    ++attempts.preparations;
    return put_away(world);
  }
  bool halfway = false;
  if (!handling->reached && !in_hand && may_prepare) {
    handling = plan_turn(what, by_rad / 2, world, means_, held, attempts.tried);
    halfway = true;
  }
  if (!handling->reached) return cannot({Code::no_turn, {object.name}});
  if (!handling->has_room) return cannot({Code::no_room_to_turn, {object.name}});
  begin_attempt();
  attempts.preparations += halfway;
  state_.under_way.preparing = halfway;
  begin_handling(*handling, in_hand);
}

// Decides on one push after the other, from the object's present place.
void Avatar::decide_push(const WorldSnapshot& world) {
  AvatarAct& act = state_.act;
  Attempts& attempts = state_.attempts;
  HandlingUnderWay& under_way = state_.under_way;
  const ObjectState& object = *world.find(act.command.object);
  under_way.object = index_of(object.name);
  if (!act.yaw_WG) {
    const auto occupied = act.command.goal.relation ? Occupied::avoided : Occupied::cleared;
    const auto place =
        placement(act.command, world, occupied, [&](const Vec3& p_W) { return hand_reaches(physics_.avatar(), p_W); });
    if (!place) return cannot(place.reason());
    act.p_WG = place->p_WO;
    act.yaw_WG = object.yaw;
  }
  begin_attempt();
  if (attempts.pushes >= most_pushes || !needs_push(object, act.p_WG, means_)) return begin_phases({Phase::settle});
  const auto push = plan_push(object, act.p_WG, act.landmark(), world, means_);
  if (!push) {
    // No further push brings the object nearer, but it may be near enough.
    const bool near = (act.p_WG - object.p_WO).head<2>().norm() <= set_down_error_m;
    if (attempts.pushes > 0 && near) return begin_phases({Phase::settle});
    return cannot(push.reason());
  }
  // The next push adds the length that the last ones in this direction lacked.
  constexpr double same_direction = 0.99;  // cosine
  const bool again = attempts.pushes > 0 && push->ahead_W.dot(under_way.push.ahead_W) > same_direction;
  attempts.short_m = again ? attempts.short_m + (act.p_WG - object.p_WO).dot(push->ahead_W) : 0;
  ++attempts.pushes;
  under_way.push = *push;
  under_way.push.end_X_WT.p_WB += attempts.short_m * push->ahead_W;
  under_way.preparing = true;
  begin_phases({Phase::behind, Phase::push, Phase::back_off});
}

void Avatar::begin_handling(const Handling& handling, bool in_hand) {
  const AvatarAct& act = state_.act;
  HandlingUnderWay& under_way = state_.under_way;
  under_way.handling = handling;
  under_way.let_go.reset();
  under_way.object = index_of(handling.object);
  std::deque<Phase> phases;
  if (!in_hand) phases = {Phase::approach, Phase::close};
  const bool turning = act.command.what == Capability::turn;
  if (handling.set_down && (under_way.preparing || turning || is_carried(act.command.what))) {
    const WorldSnapshot world = physics_.snapshot({});
    const ObjectState& object = *world.find(handling.object);
    const bool in_the_air = object.bounds_W().min.z() - height_under(object, world) > standing_m;
    phases.push_back(Phase::carry);
    if (!turning || under_way.preparing || !in_the_air)
      phases.push_back(handling.into.empty() ? Phase::lower : Phase::insert);
    if (handling.set_down->shove_from_W) phases.push_back(Phase::shove);
    if (under_way.preparing || act.lets_go) phases.insert(phases.end(), {Phase::open, Phase::retreat, Phase::settle});
  } else if (act.command.what == Capability::lift) {
    phases.push_back(Phase::raise);
  }
  begin_phases(std::move(phases));
}

}  // namespace continua
