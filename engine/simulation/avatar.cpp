#include "continua/simulation/avatar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "continua/body/placement.h"
#include "continua/core/angles.h"
#include "continua/simulation/feasibility.h"
#include "continua/simulation/hand_route.h"

namespace continua {

namespace {

using Code = ReasonCode;
using Status = ActStatus;

constexpr double turned_wrong = 0.17;  // radians (10 degrees): a turn with a larger error has missed
constexpr double mm_per_m = 1000;
// A failed act is tried once more. If the arm finds no way with a grip, two other grips are tried.
constexpr int most_retries = 1, most_detours = 2;
// Half of the speeds of rest: a toppling object does not stay below them for long.
constexpr double quiet_m_per_s = 1e-3, quiet_rad_per_s = 0.025;

ObjectShapes shapes_of(const std::vector<SceneObject>& objects) {
  ObjectShapes shapes;
  for (const auto& object : objects) shapes[object.name] = object.shape;
  return shapes;
}

}  // namespace

Avatar::Avatar(Physics& physics)
    : physics_(physics),
      shapes_(shapes_of(physics.objects())),
      means_{physics.avatar(), shapes_},
      state_{.motion = Motion(physics.hinges(), resting_opening_m)} {}

int Avatar::index_of(const std::string& object) const {
  const auto& objects = physics_.objects();
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const auto& one) { return one.name == object; });
  return found == objects.end() ? -1 : static_cast<int>(found - objects.begin());
}

bool Avatar::may_be_superseded() const { return busy_ && is_gesture(state_.act.command.what); }

std::optional<ActReport> Avatar::take_result() { return std::exchange(result_, std::nullopt); }

void Avatar::begin(const AvatarCommand& asked) {
  AvatarAct& act = state_.act;
  act = AvatarAct{.command = asked};
  AvatarCommand& command = act.command;
  state_.attempts = {};
  state_.under_way.let_go.reset();
  result_.reset();
  if (command.what == Capability::stop) return halt();
  busy_ = true;
  if (command.what == Capability::retract) {
    state_.under_way.preparing = false;
    return begin_phases({Phase::withdraw, Phase::go_home});
  }

  const WorldSnapshot world = physics_.snapshot({});
  if (command.object.empty() && !is_gesture(command.what)) command.object = world.held;
  const bool in_hand = !command.object.empty() && world.held == command.object;
  act.lets_go = empties_hand(command.what, in_hand);
  command = with_next_goal(std::move(command));
  if (command.what == Capability::grasp && in_hand) return end_act();
  if (command.what == Capability::move && !in_hand)
    return cannot(command.object.empty() ? Reason{Code::nothing_held} : Reason{Code::not_held, {command.object}});
  decide();
}

// Ends the act under way where it is. Fingers that hold an object keep it; closing fingers open again.
void Avatar::halt() {
  if (!busy_) return end_act();
  if (!state_.run.phases.empty() && state_.run.phases.front() == Phase::close) {
    if (physics_.held() < 0) {
      physics_.set_grip(-1);
      state_.motion.wanted_opening_m = state_.motion.release_opening_m;
    } else if (state_.run.steady_steps == 0) {
      PhaseWork work{physics_, state_};
      hold_firmly(work);
    }
  }
  state_.motion.brake();
  state_.run.failing = false;
  state_.under_way.preparing = false;
  begin_phases({Phase::halt});
}

void Avatar::abandon(Reason reason) {
  state_.motion.stay_at(physics_.hinges());
  if (!busy_) return;
  state_.act.outcome = {};
  state_.act.outcome.end_for(std::move(reason));
  end_act();
}

void Avatar::begin_phases(std::deque<Phase> phases) {
  state_.run.phases = std::move(phases);
  begin_phase();
}

void Avatar::begin_phase() {
  PhaseRun& run = state_.run;
  run.elapsed_s = 0;
  run.steady_steps = 0;
  run.lag_rad = 0;
  PhaseWork work{physics_, state_};
  // At the end of a failed handling the arm skips impossible phases.
  while (!run.phases.empty() && !continua::begin_phase(run.phases.front(), work)) {
    if (!run.failing) return fail({Code::no_way});
    run.phases.pop_front();
  }
  if (run.phases.empty()) phases_done();
}

const AvatarTarget& Avatar::update() {
  const double dt_s = physics_.timestep_s();
  auto& let_go = state_.under_way.let_go;
  if (let_go) let_go->ago_s += dt_s;
  const bool quiet = physics_.objects_slower_than(quiet_m_per_s, quiet_rad_per_s);
  state_.quiet_steps = quiet ? state_.quiet_steps + 1 : 0;
  PhaseRun& run = state_.run;
  if (busy_ && !run.phases.empty()) {
    PhaseWork work{physics_, state_};
    PhaseEnd end = end_of_phase(run.phases.front(), work);
    if (end.failure) {
      fail(*std::move(end.failure));
    } else if (end.ended) {
      run.phases.pop_front();
      begin_phase();
    }
  }
  run.elapsed_s += dt_s;
  return state_.motion.advance(dt_s);
}

// A handling has ended: the next one of the act, its judgement, or another attempt.
void Avatar::phases_done() {
  AvatarAct& act = state_.act;
  if (act.command.what == Capability::stop) return end_act();
  if (act.outcome.status == Status::done && state_.under_way.preparing) return decide();
  if (act.outcome.status == Status::done) {
    const WorldSnapshot world = physics_.snapshot({});
    measure(world);
    if (auto failure = judge(world)) act.outcome.end_for(*std::move(failure));
  }
  if (!try_again()) end_act();
}

// Begins another attempt if the failed act has one left. Returns true if it did.
bool Avatar::try_again() {
  const AvatarAct& act = state_.act;
  Attempts& attempts = state_.attempts;
  const bool spent =
      act.outcome.status == Status::unreachable ? attempts.detours >= most_detours : attempts.retried >= most_retries;
  if (act.outcome.status == Status::done || !needs_object(act.command.what) || spent) return false;
  if (!state_.under_way.preparing) attempts.tried.push_back(state_.under_way.handling.grip);
  decide();
  return true;
}

// The object stands in the relation of the goal. A step to a side of the object itself is a place, not a relation.
bool Avatar::is_related(const WorldSnapshot& world) const {
  const AvatarCommand& command = state_.act.command;
  const Goal& goal = command.goal;
  std::vector<Landmark> landmarks;
  for (const auto& name : goal.landmarks) {
    if (name == command.object) return true;
    landmarks.push_back(*Landmark::named(name, world));
  }
  return !goal.relation ||
         holds_by(*goal.relation, *world.find(command.object), landmarks, world.table, goal.perspective) > 0;
}

// The released object has moved since, or still moves.
bool Avatar::moved_again(const WorldSnapshot& world) const {
  constexpr double moved_m = 0.01, tipped_rad = 0.2;
  // A tremble on the spot is no movement.
  constexpr double trembles_m = 1e-3, trembles_rad = 0.02;
  const auto& let_go = state_.under_way.let_go;
  if (!let_go) return false;
  const Pose X_WO = physics_.object_pose(let_go->object);
  const auto farther = [&](double m, double rad) {
    return (X_WO.p_WB - let_go->X_WO.p_WB).norm() > m || X_WO.R_WB.angularDistance(let_go->X_WO.R_WB) > rad;
  };
  if (state_.quiet_steps * physics_.timestep_s() < quiet_s && farther(trembles_m, trembles_rad)) return true;
  // An object dropped into a hollow moves until it lies there.
  const ObjectState& object = world.objects[static_cast<std::size_t>(let_go->object)];
  for (const auto& other : world.objects) {
    const std::array landmarks = {Landmark::object(other)};
    if (other.interior && other.name != object.name &&
        holds_by(Relation::in, object, landmarks, world.table, Perspective::avatar) > 0)
      return false;
  }
  return farther(moved_m, tipped_rad);
}

// Measures the errors of position and yaw.
void Avatar::measure(const WorldSnapshot& world) {
  constexpr double yaw_grid = 1e-3;  // radians
  AvatarAct& act = state_.act;
  const AvatarCommand& command = act.command;
  if (!moves_to_goal(command.what) && command.what != Capability::turn) return;
  const Vec3 p_WO = physics_.object_pose(index_of(command.object)).p_WB;
  act.outcome.position_error_m = on_grid((p_WO - act.p_WG).head<2>().norm());
  const auto shape = shapes_.find(command.object);
  const bool is_round = shape != shapes_.end() && shape->second.is_round();
  if (!act.yaw_WG || is_round) return;
  const double off = std::remainder(world.find(command.object)->yaw - *act.yaw_WG, full_turn);
  act.outcome.yaw_error = yaw_grid * std::round(off / yaw_grid);
}

// The reason why the act failed, if it did, from the state of the world.
std::optional<Reason> Avatar::judge(const WorldSnapshot& world) const {
  const AvatarCommand& command = state_.act.command;
  const ActReport& outcome = state_.act.outcome;
  const Goal& goal = command.goal;
  if (moved_again(world)) {
    const int object = state_.under_way.let_go->object;
    return Reason{Code::moved_again, {world.objects[object].name}};
  }
  if (command.what == Capability::turn && std::abs(outcome.yaw_error) > turned_wrong)
    return Reason{
        Code::turned_wrong, {command.object}, {fmt::format("{:.0f}", std::abs(outcome.yaw_error) / rad_per_deg)}};
  // Anywhere in a hollow will do.
  const bool inside = moves_to_goal(command.what) && goal.relation == Relation::in;
  if (!inside && outcome.position_error_m > set_down_error_m)
    return Reason{Code::off_goal, {command.object}, {fmt::format("{:.0f}", mm_per_m * outcome.position_error_m)}};
  if (moves_to_goal(command.what) && !is_related(world))
    return reason_about_goal(Code::not_related, command.object, goal);
  return std::nullopt;
}

// Ends the handling as failed, with an open hand clear of things. The first failure counts.
void Avatar::fail(Reason reason) {
  AvatarAct& act = state_.act;
  if (act.outcome.status == Status::done) act.outcome.end_for(std::move(reason));
  state_.run.failing = true;
  const bool retreating = !state_.run.phases.empty() && state_.run.phases.front() == Phase::retreat;
  state_.motion.stay();
  // By the hinges alone the arm gets home from everywhere, and from there to places that it could not reach before.
  if (retreating || is_gesture(act.command.what) || act.command.what == Capability::retract)
    return begin_phases({Phase::go_home});
  if (physics_.held() >= 0)
    return begin_phases({Phase::lower, Phase::open, Phase::retreat, Phase::go_home, Phase::settle});
  begin_phases({Phase::open, Phase::retreat, Phase::go_home, Phase::settle});
}

void Avatar::end_act() {
  AvatarAct& act = state_.act;
  state_.run.phases.clear();
  if (!state_.motion.is_over()) state_.motion.stay();
  busy_ = false;
  act.outcome.moved_aside = act.moved_aside;
  act.outcome.retries = state_.attempts.retries;
  const Capability what = act.command.what;
  const bool handles = !is_gesture(what) && what != Capability::stop;
  const auto& let_go = state_.under_way.let_go;
  const std::string object = what == Capability::ungrasp && let_go
                                 ? physics_.objects()[static_cast<std::size_t>(let_go->object)].name
                                 : act.command.object;
  const int handled = handles ? index_of(object) : -1;
  if (handled >= 0) act.outcome.touches = physics_.touched_by(handled);
  result_ = act.outcome;
}

}  // namespace continua
