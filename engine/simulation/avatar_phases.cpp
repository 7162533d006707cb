#include <algorithm>

#include <fmt/format.h>

#include "simulation/avatar.h"
#include "simulation/hand_route.h"
#include "simulation/stacks.h"

namespace continua {

namespace {

using Status = ActReport::Status;

constexpr double fade_s = 0.25;  // in which a superseded motion fades out
constexpr double finger_m_per_s = 0.15;
constexpr double squeeze_N = 8;        // with which each finger holds
constexpr double further_m = 0.003;    // down, than should be needed: contact ends the motion
constexpr double touch_force_N = 2.5;  // of set-down: a block weighs about 1 N
constexpr Pace gentle{0.12, 1.5, 10};
constexpr Pace loaded{0.9, 2.5, 18}, careful{0.4, 1.2, 4};
// Half of what counts as rest: what is about to topple does not stay below this for so long.
constexpr double quiet_m_per_s = 1e-3, quiet_rad_per_s = 0.025;

}  // namespace

// ---- Poses ---------------------------------------------------------------------------------------------------------

/// The hand's pose when what it holds is at `p_WO`, as it was grasped or turned as it shall be at the goal.
Pose Avatar::hand_for_object(const Vec3& p_WO, bool turned) const {
  const Pose X_WT = tool_pose(physics_.arm(), physics_.hinges());
  const Vec3 p_TO = X_WT.R_WB.conjugate() * (physics_.object_pose(object_).p_WB - X_WT.p_WB);
  const Eigen::Quaterniond R_WT = hand_at(handling_.grip, p_WO, turned).R_WB;
  return {p_WO + (turned ? handling_.grip.aside_W : Vec3::Zero()) - R_WT * p_TO, R_WT};
}

Pose Avatar::gesture_pose(const WorldSnapshot& world) const {
  const ObjectState* object = world.find(command_.object);
  Vec3 p_W = object ? object->p_WO : command_.goal.p_WG;
  if (object) p_W.z() = object->bounds_W().max.z();
  const Arm& arm = physics_.arm();
  if (command_.what != Capability::point || !world.held.empty())
    return hover_pose(object, p_W, world, tool_pose(arm, physics_.hinges()), physics_.avatar());
  const auto poses = pointing_poses(p_W, arm.base_W());
  const auto reached = [&](const Pose& X_WT) { return find_ik(arm, X_WT).reached; };
  const auto found = std::find_if(poses.begin(), poses.end(), reached);
  return found == poses.end() ? poses.front() : *found;
}

// ---- Motion --------------------------------------------------------------------------------------------------------

bool Avatar::go(const std::vector<Pose>& X_WT, const Pace& pace) {
  const AvatarForm& avatar = physics_.avatar();
  const auto things = things_around(physics_.snapshot({}));
  const auto depth = [&](const ArmVector& q) {
    return std::max(arm_conflict(avatar, q, things),
                    hand_conflict(avatar.hand, tool_pose(avatar.arm, q), target_.opening_m, things));
  };
  auto path = HandPath::plan(physics_.arm(), target_.hinges.q, X_WT, pace, depth);
  if (!path) return false;
  path_ = std::move(*path);
  path_s_ = 0;
  leftover_qdot_ = target_.hinges.qdot;
  behind_q_.setZero();
  return true;
}

void Avatar::stop_here() {
  path_ = HandPath::stay(target_.hinges.q);
  path_s_ = 0;
  leftover_qdot_.setZero();
  behind_q_.setZero();
}

/// Comes to a stand in the way it is going.
void Avatar::brake() {
  const HingeTarget from = target_.hinges;
  stop_here();
  behind_q_ = from.qdot * fade_s / 3;
  path_ = HandPath::stay(from.q + behind_q_);
}

/// A second attempt goes slowly: a weak hand holds then what had slipped out of it.
Pace Avatar::carrying_pace() const { return retries_.empty() ? loaded : careful; }

/// Presses by position, not by force: what is between the fingers then has a place there.
void Avatar::hold_firmly() {
  wanted_opening_m_ = target_.opening_m - squeeze_N / physics_.avatar().hand.finger_N_per_m;
}

bool Avatar::arrived() const {
  constexpr double near_rad = 2e-3, patience_s = 0.25;
  if (path_s_ < path_.duration_s()) return false;
  return path_s_ > path_.duration_s() + patience_s ||
         (physics_.hinges() - path_.end()).cwiseAbs().maxCoeff() < near_rad;
}

/// The hand, or what it holds, meets something that it should not.
bool Avatar::pushes_hard() {
  constexpr double hard_N = 25;
  constexpr int firm_steps = 5;
  const int held = physics_.held();
  const bool hard = physics_.outside_force(-1) > hard_N || (held >= 0 && physics_.outside_force(held) > hard_N);
  steps_so_ = hard ? steps_so_ + 1 : 0;
  return steps_so_ >= firm_steps;
}

const AvatarTarget& Avatar::update() {
  if (let_go_) let_go_->ago_s += dt_s_;
  quiet_steps_ = physics_.objects_slower_than(quiet_m_per_s, quiet_rad_per_s) ? quiet_steps_ + 1 : 0;
  if (busy_ && phase_ended()) {
    phases_.pop_front();
    begin_phase();
  }
  phase_s_ += dt_s_;
  path_s_ += dt_s_;
  target_.hinges = path_.at(path_s_);
  if (path_s_ < fade_s) {
    const double left = 1 - path_s_ / fade_s;
    target_.hinges.q += (leftover_qdot_ * path_s_ - behind_q_) * left * left * left;
    target_.hinges.qdot += leftover_qdot_ * left * left * (left - 3 * path_s_ / fade_s);
    target_.hinges.qdot += behind_q_ * 3 / fade_s * left * left;
  }
  const double step_m = finger_m_per_s * dt_s_;
  target_.opening_m += std::clamp(wanted_opening_m_ - target_.opening_m, -step_m, step_m);
  return target_;
}

// ---- Phases --------------------------------------------------------------------------------------------------------

void Avatar::begin_phase() {
  phase_s_ = 0;
  steps_so_ = 0;
  // Of what ends a failed handling, the arm leaves out what it cannot do.
  while (!phases_.empty() && !move_to(phases_.front(), physics_.snapshot({}))) {
    if (!failing_) return fail(Status::unreachable, "the arm does not get there");
    phases_.pop_front();
  }
  if (phases_.empty()) phases_done();
}

/// Tells arm and fingers what the phase wants of them. False if the arm cannot do it.
bool Avatar::move_to(Phase phase, const WorldSnapshot& world) {
  const int held = physics_.held();
  const AvatarForm& avatar = physics_.avatar();
  const Pose from = tool_pose(physics_.arm(), target_.hinges.q);
  switch (phase) {
    case Phase::hover:
      if (world.held.empty()) wanted_opening_m_ = command_.what == Capability::point ? 0 : resting_opening_m;
      return go(way_over(from, gesture_pose(world), world, avatar));
    case Phase::approach:
      wanted_opening_m_ = handling_.grip.opening_m;
      return go(way_to_grasp(from, hand_at(handling_.grip, world.objects[object_].p_WO, false), world, avatar));
    case Phase::close:
      physics_.set_grip(object_);
      release_opening_m_ = handling_.grip.opening_m;
      wanted_opening_m_ = 0;
      return true;
    case Phase::raise:
      return go({hand_for_object(p_WG_, false)}, carrying_pace());
    case Phase::carry: {
      constexpr double above_m = 0.01, drag_m = 0.001;
      const Vec3 first_at = handling_.set_down->first_W();
      const bool may_slide = command_.what == Capability::slide || stage_ == Stage::preparation;
      along_table_ = may_slide && command_.what != Capability::turn &&
                     way_is_free(world.objects[object_], first_at, landmark(), world);
      const Vec3& half_extents_m = world.objects[object_].half_extents_m;
      const double half_m = handling_.on_end ? half_extents_m.maxCoeff() : half_extents_m.z();
      double up_m = along_table_ ? drag_m : above_m;
      if (const ObjectState* container = world.find(handling_.into))
        up_m = std::max(up_m, container->bounds_W().max.z() + above_m - (first_at.z() - half_m));
      const Vec3 over_goal = first_at + Vec3(0, 0, up_m);
      const Pose at_goal = hand_for_object(over_goal, true);
      if (along_table_) return go({at_goal}, carrying_pace());
      return go(way_over(from, at_goal, world, avatar, at_goal.p_WB.z() - (over_goal.z() - half_m)), carrying_pace());
    }
    case Phase::insert:
      return held < 0 || go({hand_for_object(handling_.set_down->p_WO - Vec3(0, 0, further_m), true)}, gentle);
    case Phase::lower: {
      if (held < 0) return true;
      const ObjectState& object = world.objects[held];
      const double down = object.bounds_W().min.z() - height_under(object, world);
      return go({{from.p_WB - Vec3(0, 0, std::max(0.0, down + further_m)), from.R_WB}}, gentle);
    }
    case Phase::shove: {
      Vec3 p_WO = handling_.set_down->p_WO;
      if (held >= 0) p_WO.z() = physics_.object_pose(held).p_WB.z();
      return held != object_ || go({hand_for_object(p_WO, true)}, gentle);
    }
    case Phase::open:
      stop_here();
      if (held >= 0) let_go_ = {held, physics_.object_pose(held), 0};
      physics_.set_grip(-1);
      wanted_opening_m_ = std::max(release_opening_m_, target_.opening_m);
      return true;
    case Phase::retreat:
      return go({before_grasp(from)});
    case Phase::behind:
      wanted_opening_m_ = push_.opening_m;
      return go(way_over(from, push_.behind_X_WT, world, avatar));
    case Phase::push:
      return go({push_.end_X_WT}, gentle);
    case Phase::back_off: {
      constexpr double back_m = 0.015;
      const Pose back{from.p_WB - back_m * push_.ahead_W, from.R_WB};
      let_go_ = {object_, physics_.object_pose(object_), 0};
      return go({back, before_grasp(back)});
    }
    case Phase::withdraw: {
      if (held < 0) wanted_opening_m_ = resting_opening_m;
      const double below_m = held < 0 ? 0 : from.p_WB.z() - world.objects[held].bounds_W().min.z();
      // What cannot be done in a straight line is done by the hinges alone, in the next phase.
      go(way_over(from, tool_pose(physics_.arm(), physics_.arm().home), world, avatar, below_m));
      return true;
    }
    case Phase::go_home:
      stop_here();
      path_ = HandPath::between(target_.hinges.q, physics_.arm().home);
      return true;
    case Phase::settle:
    case Phase::halt:
      return true;
  }
  return true;
}

bool Avatar::phase_ended() {
  if (phases_.empty()) return false;
  const int held = physics_.held();
  switch (phases_.front()) {
    case Phase::hover:
    case Phase::retreat:
    case Phase::back_off:
      return arrived();
    case Phase::withdraw:
    case Phase::go_home:
      if (command_.what == Capability::retract && pushes_hard()) {
        fail(Status::blocked, "something is in the hand's way");
        return false;
      }
      return arrived();
    case Phase::push:
      if (pushes_hard()) {
        fail(Status::blocked, fmt::format("something is in {}'s way", command_.object));
        return false;
      }
      return arrived();
    case Phase::behind:
    case Phase::approach:
      if (pushes_hard()) {
        fail(Status::blocked, "something is in the hand's way");
        return false;
      }
      return arrived();
    case Phase::close: {
      constexpr int firm_steps = 50;
      constexpr double patience_s = 1.2;
      steps_so_ = held == object_ ? steps_so_ + 1 : 0;
      if (steps_so_ == 1) hold_firmly();
      if (steps_so_ >= firm_steps) return true;
      if (phase_s_ > patience_s) fail(Status::blocked, "the fingers found no hold");
      return false;
    }
    case Phase::raise:
    case Phase::carry:
      if (held != object_) {
        fail(Status::dropped, fmt::format("{} slipped out of the fingers", handling_.object));
        return false;
      }
      if (pushes_hard()) {
        fail(Status::blocked, fmt::format("something is in {}'s way", handling_.object));
        return false;
      }
      return arrived();
    case Phase::shove:
      return held != object_ || arrived();
    case Phase::lower:
    case Phase::insert: {
      constexpr int firm_steps = 3;
      if (held < 0) return true;
      const bool touches = physics_.outside_force(held) > touch_force_N || physics_.outside_force(-1) > touch_force_N;
      steps_so_ = touches ? steps_so_ + 1 : 0;
      return steps_so_ >= firm_steps || arrived();
    }
    case Phase::open: {
      constexpr double patience_s = 0.8;
      return target_.opening_m >= wanted_opening_m_ || phase_s_ > patience_s;
    }
    case Phase::settle: {
      constexpr double patience_s = 1, least_s = 0.1;
      const double since_s = let_go_ ? let_go_->ago_s : phase_s_;
      return quiet_steps_ * dt_s_ >= quiet_s || (since_s > patience_s && phase_s_ > least_s);
    }
    case Phase::halt: {
      constexpr double patience_s = 0.8;
      const bool fingers_done = held >= 0 || target_.opening_m == wanted_opening_m_;
      return phase_s_ > patience_s || (phase_s_ > fade_s && arrived() && fingers_done);
    }
  }
  return true;
}

}  // namespace continua
