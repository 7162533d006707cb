#include "continua/simulation/avatar_phases.h"

#include <algorithm>
#include <array>

#include "continua/simulation/hand_route.h"
#include "continua/simulation/stacks.h"

namespace continua {

namespace {

using Code = ReasonCode;

constexpr double squeeze_N = 8;        // with which each finger holds
constexpr double further_m = 0.003;    // the hand aims this far below the expected height: contact ends the motion
constexpr double touch_force_N = 2.5;  // at set-down; a block weighs about 1 N
// Slow enough to stop at a contact before it pushes hard.
constexpr Pace gentle{.hand_m_per_s = 0.12, .hinge_rad_per_s = 1.5, .hinge_rad_per_s2 = 10};
// Slower than the empty hand, lest the object slip; a second attempt is slower still.
constexpr Pace loaded{.hand_m_per_s = 0.9, .hinge_rad_per_s = 2.5, .hinge_rad_per_s2 = 18};
constexpr Pace careful{.hand_m_per_s = 0.4, .hinge_rad_per_s = 1.2, .hinge_rad_per_s2 = 4};

// ---- Poses and motions ---------------------------------------------------------------------------------------------

Pose hand_now(const PhaseWork& work) { return tool_pose(work.physics.arm(), work.state.motion.target().hinges.q); }

// The hand's pose with the held object at `p_WO`, either as grasped or turned as at the goal.
Pose hand_for_object(const PhaseWork& work, const Vec3& p_WO, bool turned) {
  const HandlingUnderWay& under_way = work.state.under_way;
  const Grip& grip = under_way.handling.grip;
  const Pose X_WT = tool_pose(work.physics.arm(), work.physics.hinges());
  const Vec3 p_TO = X_WT.R_WB.conjugate() * (work.physics.object_pose(under_way.object).p_WB - X_WT.p_WB);
  const Eigen::Quaterniond R_WT = hand_at(grip, p_WO, turned).R_WB;
  return {p_WO + (turned ? grip.aside_W : Vec3::Zero()) - R_WT * p_TO, R_WT};
}

bool go(PhaseWork& work, const std::vector<Pose>& X_WT, const Pace& pace = {}) {
  Motion& motion = work.state.motion;
  const AvatarForm& avatar = work.physics.avatar();
  const auto things = things_around(work.physics.snapshot({}));
  const auto depth = [&](const ArmVector& q) {
    return std::max(arm_conflict(avatar, q, things),
                    hand_conflict(avatar.hand, tool_pose(avatar.arm, q), motion.target().opening_m, things));
  };
  auto path = HandPath::plan(work.physics.arm(), motion.target().hinges.q, X_WT, pace, depth);
  if (!path) return false;
  motion.follow(*std::move(path));
  return true;
}

// A second attempt goes slowly, because a weak hand then holds an object that had slipped out of it.
Pace carrying_pace(const PhaseWork& work) { return work.state.attempts.retries.empty() ? loaded : careful; }

// ---- Beginnings ----------------------------------------------------------------------------------------------------

bool begin_nothing(PhaseWork&, const WorldSnapshot&) { return true; }

bool begin_hover(PhaseWork& work, const WorldSnapshot& world) {
  const AvatarCommand& command = work.state.act.command;
  if (world.held.empty())
    work.state.motion.wanted_opening_m = command.what == Capability::point ? 0 : resting_opening_m;
  return go(work, way_over(hand_now(work), gesture_pose(command, work.physics, world), world, work.physics.avatar()));
}

bool begin_approach(PhaseWork& work, const WorldSnapshot& world) {
  const HandlingUnderWay& under_way = work.state.under_way;
  const Grip& grip = under_way.handling.grip;
  work.state.motion.wanted_opening_m = grip.opening_m;
  const Pose at_object = hand_at(grip, world.objects[under_way.object].p_WO, false);
  return go(work, way_to_grasp(hand_now(work), at_object, world, work.physics.avatar()));
}

bool begin_close(PhaseWork& work, const WorldSnapshot&) {
  const HandlingUnderWay& under_way = work.state.under_way;
  work.physics.set_grip(under_way.object);
  work.state.motion.release_opening_m = under_way.handling.grip.opening_m;
  work.state.motion.wanted_opening_m = 0;
  return true;
}

bool begin_raise(PhaseWork& work, const WorldSnapshot&) {
  return go(work, {hand_for_object(work, work.state.act.p_WG, false)}, carrying_pace(work));
}

// Along the table if the way is free, and the act is a slide or only makes room; else across above everything.
bool begin_carry(PhaseWork& work, const WorldSnapshot& world) {
  constexpr double above_m = 0.01;  // the object comes to this height above its goal
  constexpr double drag_m = 0.001;  // and slides at this height above the table, lest friction turn it
  const AvatarAct& act = work.state.act;
  const HandlingUnderWay& under_way = work.state.under_way;
  const Handling& handling = under_way.handling;
  const ObjectState& object = world.objects[under_way.object];
  const Vec3 first_at = handling.set_down->first_W();
  const bool may_slide = act.command.what == Capability::slide || under_way.preparing;
  const bool along_table =
      may_slide && act.command.what != Capability::turn && way_is_free(object, first_at, act.landmark(), world);
  const double half_m = handling.on_end ? object.half_extents_m.maxCoeff() : object.half_extents_m.z();
  double up_m = along_table ? drag_m : above_m;
  if (const ObjectState* container = world.find(handling.into))
    up_m = std::max(up_m, container->bounds_W().max.z() + above_m - (first_at.z() - half_m));
  const Vec3 over_goal = first_at + Vec3(0, 0, up_m);
  const Pose at_goal = hand_for_object(work, over_goal, true);
  if (along_table) return go(work, {at_goal}, carrying_pace(work));
  const double below_m = at_goal.p_WB.z() - (over_goal.z() - half_m);
  return go(work, way_over(hand_now(work), at_goal, world, work.physics.avatar(), below_m), carrying_pace(work));
}

bool begin_insert(PhaseWork& work, const WorldSnapshot&) {
  const Vec3 deeper_m(0, 0, further_m);
  return work.physics.held() < 0 ||
         go(work, {hand_for_object(work, work.state.under_way.handling.set_down->p_WO - deeper_m, true)}, gentle);
}

bool begin_lower(PhaseWork& work, const WorldSnapshot& world) {
  const int held = work.physics.held();
  if (held < 0) return true;
  const ObjectState& object = world.objects[held];
  const double down_m = object.bounds_W().min.z() - height_under(object, world);
  const Pose from = hand_now(work);
  return go(work, {{from.p_WB - Vec3(0, 0, std::max(0.0, down_m + further_m)), from.R_WB}}, gentle);
}

bool begin_shove(PhaseWork& work, const WorldSnapshot&) {
  const HandlingUnderWay& under_way = work.state.under_way;
  const int held = work.physics.held();
  Vec3 p_WO = under_way.handling.set_down->p_WO;
  if (held >= 0) p_WO.z() = work.physics.object_pose(held).p_WB.z();
  return held != under_way.object || go(work, {hand_for_object(work, p_WO, true)}, gentle);
}

bool begin_open(PhaseWork& work, const WorldSnapshot&) {
  const int held = work.physics.held();
  Motion& motion = work.state.motion;
  motion.stay();
  if (held >= 0) work.state.under_way.let_go = {held, work.physics.object_pose(held), 0};
  work.physics.set_grip(-1);
  motion.wanted_opening_m = std::max(motion.release_opening_m, motion.target().opening_m);
  return true;
}

bool begin_retreat(PhaseWork& work, const WorldSnapshot&) { return go(work, {before_grasp(hand_now(work))}); }

bool begin_behind(PhaseWork& work, const WorldSnapshot& world) {
  const Push& push = work.state.under_way.push;
  work.state.motion.wanted_opening_m = push.opening_m;
  return go(work, way_over(hand_now(work), push.behind_X_WT, world, work.physics.avatar()));
}

bool begin_push(PhaseWork& work, const WorldSnapshot&) {
  return go(work, {work.state.under_way.push.end_X_WT}, gentle);
}

bool begin_back_off(PhaseWork& work, const WorldSnapshot&) {
  constexpr double back_m = 0.015;
  HandlingUnderWay& under_way = work.state.under_way;
  const Pose from = hand_now(work);
  const Pose back{from.p_WB - back_m * under_way.push.ahead_W, from.R_WB};
  under_way.let_go = {under_way.object, work.physics.object_pose(under_way.object), 0};
  return go(work, {back, before_grasp(back)});
}

bool begin_withdraw(PhaseWork& work, const WorldSnapshot& world) {
  const int held = work.physics.held();
  const Arm& arm = work.physics.arm();
  if (held < 0) work.state.motion.wanted_opening_m = resting_opening_m;
  const Pose from = hand_now(work);
  const double below_m = held < 0 ? 0 : from.p_WB.z() - world.objects[held].bounds_W().min.z();
  // Without a straight way home the next phase goes by the hinges alone.
  go(work, way_over(from, tool_pose(arm, arm.home), world, work.physics.avatar(), below_m));
  return true;
}

bool begin_go_home(PhaseWork& work, const WorldSnapshot&) {
  Motion& motion = work.state.motion;
  motion.follow_from_rest(HandPath::between(motion.target().hinges.q, work.physics.arm().home));
  return true;
}

// ---- Ends ----------------------------------------------------------------------------------------------------------

PhaseEnd failed(Reason reason) { return {false, std::move(reason)}; }

// The condition has held for that many steps without a break.
bool held_for(PhaseWork& work, bool condition, int steps) {
  PhaseRun& run = work.state.run;
  run.steady_steps = condition ? run.steady_steps + 1 : 0;
  return run.steady_steps >= steps;
}

bool has_arrived(const PhaseWork& work) {
  constexpr double near_rad = 2e-3, patience_s = 0.25;
  const Motion& motion = work.state.motion;
  if (!motion.is_over()) return false;
  return motion.is_over_since(patience_s) || (work.physics.hinges() - motion.end()).cwiseAbs().maxCoeff() < near_rad;
}

// The hand or the held object presses on something else.
bool pushes_hard(PhaseWork& work) {
  constexpr double hard_N = 25;
  constexpr int firm_steps = 5;
  const int held = work.physics.held();
  const bool hard = work.physics.outside_force(-1) > hard_N || (held >= 0 && work.physics.outside_force(held) > hard_N);
  return held_for(work, hard, firm_steps);
}

// The hinges trail far behind their targets although nothing holds the arm: whatever the hand then meets was not in its
// way.
bool lags(PhaseWork& work) {
  constexpr double far_rad = 0.1;
  double& lag_rad = work.state.run.lag_rad;
  const int held = work.physics.held();
  const bool is_free = work.physics.outside_force(-1) == 0 && (held < 0 || work.physics.outside_force(held) == 0);
  if (is_free) lag_rad = (work.physics.hinges() - work.state.motion.target().hinges.q).cwiseAbs().maxCoeff();
  return lag_rad > far_rad;
}

PhaseEnd arrived(PhaseWork& work) { return {has_arrived(work)}; }

// A motion that meets nothing on its way, or fails for that reason.
PhaseEnd arrived_without(Reason obstacle, PhaseWork& work) {
  const bool is_late = lags(work), has_met = pushes_hard(work), ended = has_arrived(work);
  if (is_late && (has_met || ended)) return failed({Code::lags});
  if (has_met) return failed(std::move(obstacle));
  return {ended};
}

PhaseEnd arrived_unhindered(PhaseWork& work) { return arrived_without({Code::hand_obstructed}, work); }

// At the end of an act the arm may graze things on its way home; a retract must not.
PhaseEnd got_home(PhaseWork& work) {
  return work.state.act.command.what == Capability::retract ? arrived_unhindered(work) : arrived(work);
}

PhaseEnd carried(PhaseWork& work) {
  const HandlingUnderWay& under_way = work.state.under_way;
  const std::string& object = under_way.handling.object;
  if (work.physics.held() != under_way.object) return failed({Code::slipped, {object}});
  return arrived_without({Code::obstructed, {object}}, work);
}

PhaseEnd pushed(PhaseWork& work) { return arrived_without({Code::obstructed, {work.state.act.command.object}}, work); }

PhaseEnd shoved(PhaseWork& work) { return {work.physics.held() != work.state.under_way.object || has_arrived(work)}; }

PhaseEnd closed(PhaseWork& work) {
  constexpr int firm_steps = 50;
  constexpr double patience_s = 1.2;
  const bool firm = held_for(work, work.physics.held() == work.state.under_way.object, firm_steps);
  if (work.state.run.steady_steps == 1) hold_firmly(work);
  if (!firm && work.state.run.elapsed_s > patience_s) return failed({Code::no_hold});
  return {firm};
}

PhaseEnd touched_down(PhaseWork& work) {
  constexpr int firm_steps = 3;
  const int held = work.physics.held();
  if (held < 0) return {true};
  const bool touches =
      work.physics.outside_force(held) > touch_force_N || work.physics.outside_force(-1) > touch_force_N;
  return {held_for(work, touches, firm_steps) || has_arrived(work)};
}

PhaseEnd opened(PhaseWork& work) {
  constexpr double patience_s = 0.8;
  const Motion& motion = work.state.motion;
  return {motion.target().opening_m >= motion.wanted_opening_m || work.state.run.elapsed_s > patience_s};
}

PhaseEnd settled(PhaseWork& work) {
  constexpr double patience_s = 1, least_s = 0.1;
  const AvatarState& state = work.state;
  const auto& let_go = state.under_way.let_go;
  const double since_s = let_go ? let_go->ago_s : state.run.elapsed_s;
  return {state.quiet_steps * work.physics.timestep_s() >= quiet_s ||
          (since_s > patience_s && state.run.elapsed_s > least_s)};
}

PhaseEnd halted(PhaseWork& work) {
  constexpr double patience_s = 0.8;
  const Motion& motion = work.state.motion;
  const double elapsed_s = work.state.run.elapsed_s;
  const bool fingers_done = work.physics.held() >= 0 || motion.target().opening_m == motion.wanted_opening_m;
  return {elapsed_s > patience_s || (elapsed_s > Motion::fade_s && has_arrived(work) && fingers_done)};
}

// ---- The table -----------------------------------------------------------------------------------------------------

struct Row {
  Phase phase;
  bool (*begin)(PhaseWork&, const WorldSnapshot&);
  PhaseEnd (*ended)(PhaseWork&);
};

// In the order of the enumeration.
constexpr std::array rows = {
    Row{Phase::hover, begin_hover, arrived},
    Row{Phase::approach, begin_approach, arrived_unhindered},
    Row{Phase::close, begin_close, closed},
    Row{Phase::raise, begin_raise, carried},
    Row{Phase::carry, begin_carry, carried},
    Row{Phase::lower, begin_lower, touched_down},
    Row{Phase::insert, begin_insert, touched_down},
    Row{Phase::shove, begin_shove, shoved},
    Row{Phase::open, begin_open, opened},
    Row{Phase::retreat, begin_retreat, arrived},
    Row{Phase::behind, begin_behind, arrived_unhindered},
    Row{Phase::push, begin_push, pushed},
    Row{Phase::back_off, begin_back_off, arrived},
    Row{Phase::withdraw, begin_withdraw, got_home},
    Row{Phase::go_home, begin_go_home, got_home},
    Row{Phase::settle, begin_nothing, settled},
    Row{Phase::halt, begin_nothing, halted},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].phase) != i) return false;
  return rows.size() == static_cast<std::size_t>(Phase::halt) + 1;
}
static_assert(in_order(), "each phase has its row");

const Row& row_of(Phase phase) { return rows[static_cast<std::size_t>(phase)]; }

}  // namespace

bool begin_phase(Phase phase, PhaseWork& work) { return row_of(phase).begin(work, work.physics.snapshot({})); }

PhaseEnd end_of_phase(Phase phase, PhaseWork& work) { return row_of(phase).ended(work); }

Pose gesture_pose(const AvatarCommand& command, const Physics& physics, const WorldSnapshot& world) {
  const ObjectState* object = world.find(command.object);
  Vec3 p_W = object ? object->p_WO : command.goal.p_WG;
  if (object) p_W.z() = object->bounds_W().max.z();
  const Arm& arm = physics.arm();
  if (command.what != Capability::point || !world.held.empty())
    return hover_pose(object, p_W, world, tool_pose(arm, physics.hinges()), physics.avatar());
  const auto poses = pointing_poses(p_W, arm.base_W());
  const auto reached = [&](const Pose& X_WT) { return find_ik(arm, X_WT).has_value(); };
  const auto found = std::find_if(poses.begin(), poses.end(), reached);
  return found == poses.end() ? poses.front() : *found;
}

// The fingers' goal is a position within the object, so the object keeps its place between them.
void hold_firmly(PhaseWork& work) {
  Motion& motion = work.state.motion;
  motion.wanted_opening_m = motion.target().opening_m - squeeze_N / work.physics.avatar().hand.finger_N_per_m;
}

}  // namespace continua
