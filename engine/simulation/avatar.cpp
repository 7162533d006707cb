#include "simulation/avatar.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace continua {

namespace {

using Status = ActReport::Status;

constexpr double hover_m = 0.05;       // between finger tips and what they hover over
constexpr double clearance_m = 0.025;  // between what moves across and what it passes over
constexpr double fade_s = 0.25;        // in which a superseded motion fades out
constexpr double finger_m_per_s = 0.15;
constexpr double squeeze_m = 0.01;  // by which the fingers would close further if nothing were between them
constexpr double resting_opening_m = 0.02;
constexpr double set_down_error_m = 0.02;  // beyond it a put has missed
constexpr double touch_force_N = 2.5;      // of set-down: a block weighs about 1 N
constexpr double full_turn = 6.283185307179586;
constexpr Pace gentle{0.12, 1.5, 10};
constexpr Pace loaded{0.9, 2.5, 18};

/// The hand with its fingers down, closing along `yaw`.
Pose fingers_down(const Vec3& p_WT, double yaw) {
  Eigen::Matrix3d R;
  const Vec3 x = -Vec3::UnitZ(), y(std::cos(yaw), std::sin(yaw), 0);
  R << x, y, x.cross(y);
  return {p_WT, Eigen::Quaterniond(R)};
}

/// Yaw of the closing direction.
double closing_yaw(const Pose& X_WT) {
  const Vec3 y = X_WT.R_WB * Vec3::UnitY();
  return std::atan2(y.y(), y.x());
}

bool points_down(const Pose& X_WT) { return (X_WT.R_WB * Vec3::UnitX()).z() < -0.99; }

bool is_move(Capability what) { return what == Capability::put || what == Capability::slide; }

bool is_gesture(Capability what) { return what == Capability::reach || what == Capability::point; }

}  // namespace

Avatar::Avatar(Physics& physics)
    : physics_(physics), dt_s_(physics.timestep_s()), path_(HandPath::stay(physics.hinges())) {
  wanted_opening_m_ = target_.opening_m = resting_opening_m;
  target_.hinges.q = physics.hinges();
}

bool Avatar::may_be_superseded() const { return busy_ && is_gesture(command_.what); }

std::optional<ActReport> Avatar::take_result() { return std::exchange(result_, std::nullopt); }

void Avatar::begin(const AvatarCommand& command) {
  command_ = command;
  busy_ = true;
  outcome_ = {};
  phases_.clear();
  result_.reset();
  if (!decide()) {
    end_act();
    return;
  }
  begin_phase();
}

// ---- Deciding, before anything moves -------------------------------------------------------------------------------

/// Sets out the phases. False if the act cannot be done, with the reason in `outcome_`.
bool Avatar::decide() {
  const WorldSnapshot world = physics_.snapshot({});
  const auto cannot = [&](Status status, std::string reason) {
    outcome_.status = status;
    outcome_.reason = std::move(reason);
    return false;
  };

  if (command_.object.empty() && !is_gesture(command_.what)) command_.object = world.held;
  const bool beside = is_move(command_.what) && command_.goal.relation != Goal::Relation::at;
  for (const std::string& name : {command_.object, beside ? command_.goal.landmark : std::string()}) {
    if (!name.empty() && !world.find(name)) return cannot(Status::unreachable, fmt::format("there is no '{}'", name));
  }
  if (beside && (command_.goal.landmark.empty() || command_.goal.landmark == command_.object))
    return cannot(Status::blocked, "a goal beside or on something needs another object");

  if (is_gesture(command_.what)) {
    if (!solve_ik(physics_.arm(), hover_pose(world), physics_.arm().home).reached)
      return cannot(Status::unreachable, "the arm does not reach there");
    phases_ = {Phase::hover};
    return true;
  }
  if (command_.what == Capability::ungrasp) {
    object_ = physics_.held();
    if (object_ >= 0) phases_ = {Phase::lower, Phase::open, Phase::retreat, Phase::settle};
    return true;
  }
  if (command_.object.empty()) return cannot(Status::blocked, "there is nothing in the hand");
  return decide_move(*world.find(command_.object), world);
}

bool Avatar::decide_move(const ObjectState& object, const WorldSnapshot& world) {
  const auto cannot = [&](Status status, std::string reason) {
    outcome_.status = status;
    outcome_.reason = std::move(reason);
    return false;
  };
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    if (world.objects[i].name == object.name) object_ = static_cast<int>(i);
  }

  std::optional<Vec3> goal;
  if (is_move(command_.what)) goal = goal_position(command_, world);
  if (command_.what == Capability::lift) goal = object.p_WO + Vec3(0, 0, command_.height_m);
  const bool turns = is_move(command_.what);
  if (turns) set_down_ = choose_set_down(object, *goal, world, 0.9 * set_down_error_m);
  const Vec3 first_at = set_down_.shove_from_W.value_or(set_down_.p_WO);
  const Arm& arm = physics_.arm();
  const Vec3 base_W = arm.joints[0].X_PJ.p_WB;

  ArmVector q = arm.home;
  const auto reaches = [&](const Pose& X_WT) {
    const IkSolution solution = solve_ik(arm, X_WT, q);
    q = solution.q;
    return solution.reached;
  };
  const bool in_hand = world.held == object.name;
  if (in_hand) {
    grip_.turn = 0;
    grip_.yaw = closing_yaw(tool_pose(arm, physics_.hinges()));
    grip_.p_OT = tool_pose(arm, physics_.hinges()).p_WB - object.p_WO;
  } else {
    const auto grip = choose_grip(object, world, turns ? std::optional(first_at) : std::nullopt, base_W);
    if (!grip) return cannot(Status::blocked, fmt::format("{} is too wide for the hand", object.name));
    grip_ = *grip;
    if (!reaches(fingers_down(object.p_WO + grip_.p_OT, grip_.yaw)))
      return cannot(Status::unreachable, fmt::format("the arm does not reach {}", object.name));
  }
  if (goal) {
    const Vec3 p_OT = Eigen::AngleAxisd(grip_.turn, Vec3::UnitZ()) * grip_.p_OT;
    if (!reaches(fingers_down((turns ? first_at : *goal) + p_OT, grip_.yaw + grip_.turn)))
      return cannot(Status::unreachable, "the arm does not reach the goal");
    p_WG_ = *goal;
  }

  if (!world.held.empty() && !in_hand) phases_ = {Phase::lower, Phase::open, Phase::retreat};
  if (!in_hand) phases_.insert(phases_.end(), {Phase::approach, Phase::close});
  if (command_.what == Capability::lift) phases_.push_back(Phase::raise);
  if (turns) {
    phases_.insert(phases_.end(), {Phase::carry, Phase::lower});
    if (set_down_.shove_from_W) phases_.push_back(Phase::shove);
    phases_.insert(phases_.end(), {Phase::open, Phase::retreat, Phase::settle});
  }
  return true;
}

// ---- Poses ---------------------------------------------------------------------------------------------------------

/// From where the hand is to `X_WT`, across above everything on the way.
std::vector<Pose> Avatar::over(const Pose& X_WT, const WorldSnapshot& world) const {
  const Pose from = tool_pose(physics_.arm(), target_.hinges.q);
  Box way{from.p_WB.cwiseMin(X_WT.p_WB), from.p_WB.cwiseMax(X_WT.p_WB)};
  way.min -= Vec3::Constant(0.07);
  way.max += Vec3::Constant(0.07);
  way.min.z() = -1;
  way.max.z() = 2;

  const ObjectState* held = world.find(world.held);
  const auto riders = held ? standing_on(*held, world) : std::vector<std::string>();
  double top = world.table.max.z();
  for (const auto& other : world.objects) {
    const bool moves_along =
        other.name == world.held || std::find(riders.begin(), riders.end(), other.name) != riders.end();
    if (!moves_along && overlap_depth(other.bounds_W(), way) > 0) top = std::max(top, other.bounds_W().max.z());
  }
  const double below = std::max(-HandShape{}.finger_tip_m, held ? from.p_WB.z() - held->bounds_W().min.z() : 0.0);
  const double height = top + below + clearance_m;

  // On the way the wrist turns from where it is to where it shall be, and never through its limit: the shortest turn of
  // the hand in the world may be one that the last hinge cannot make.
  const Vec3 base_W = physics_.arm().joints[0].X_PJ.p_WB;
  const auto wrist = [&](const Pose& X) {
    return std::remainder(closing_yaw(X) - natural_yaw(X.p_WB, base_W), full_turn);
  };
  const double from_wrist = wrist(from), to_wrist = wrist(X_WT);
  const bool turns = points_down(from) && points_down(X_WT) && std::abs(to_wrist - from_wrist) > 1;
  const bool far = (from.p_WB - X_WT.p_WB).head<2>().norm() > 0.01;

  std::vector<Pose> poses;
  const Vec3 start(from.p_WB.x(), from.p_WB.y(), std::max(height, from.p_WB.z()));
  const Vec3 end(X_WT.p_WB.x(), X_WT.p_WB.y(), std::max(height, X_WT.p_WB.z()));
  if ((far || turns) && from.p_WB.z() < height) poses.push_back({start, from.R_WB});
  if (turns) {
    for (const double s : {0.25, 0.5, 0.75}) {
      const Vec3 p = start + s * (end - start);
      poses.push_back(fingers_down(p, natural_yaw(p, base_W) + from_wrist + s * (to_wrist - from_wrist)));
    }
  }
  if ((far || turns) && X_WT.p_WB.z() < height) poses.push_back({end, X_WT.R_WB});
  poses.push_back(X_WT);
  return poses;
}

/// The hand's pose when what it holds is at `p_WO` and the fingers close along `yaw`.
Pose Avatar::hand_for_object(const Vec3& p_WO, double yaw) const {
  const Pose X_WT = tool_pose(physics_.arm(), physics_.hinges());
  const Vec3 p_TO = X_WT.R_WB.conjugate() * (physics_.object_pose(object_).p_WB - X_WT.p_WB);
  const Pose turned = fingers_down(p_WO, yaw);
  return {p_WO - turned.R_WB * p_TO, turned.R_WB};
}

Pose Avatar::hover_pose(const WorldSnapshot& world) const {
  const ObjectState* object = world.find(command_.object);
  Vec3 p_W = object ? object->p_WO : command_.goal.p_WG;
  if (object) p_W.z() = object->bounds_W().max.z();
  const ObjectState* held = world.find(world.held);
  if (command_.what == Capability::point && !held) return pointing_pose(p_W);

  const Pose now = tool_pose(physics_.arm(), physics_.hinges());
  const double below = held ? now.p_WB.z() - held->bounds_W().min.z() : -HandShape{}.finger_tip_m;
  const Vec3 base_W = physics_.arm().joints[0].X_PJ.p_WB;
  // The fingers close along the object's side that takes the least turning of the wrist.
  const double natural = natural_yaw(p_W, base_W);
  constexpr double quarter = 1.5707963267948966;
  const double yaw = object ? object->yaw + quarter * std::round((natural - object->yaw) / quarter) : natural;
  return fingers_down(p_W + Vec3(0, 0, below + hover_m), yaw);
}

/// Fingers stretched toward a place, from the side of the avatar, at some distance.
Pose Avatar::pointing_pose(const Vec3& p_W) const {
  constexpr double distance_m = 0.1;
  const Vec3 eye_W = physics_.arm().joints[0].X_PJ.p_WB + Vec3(0, 0, 0.15);
  const Vec3 x = (p_W - eye_W).normalized(), y = Vec3::UnitZ().cross(x).normalized();
  Eigen::Matrix3d R;
  R << x, y, x.cross(y);
  return {p_W - distance_m * x, Eigen::Quaterniond(R)};
}

/// Top of the highest thing under the footprint of an object.
double Avatar::height_under(const ObjectState& object, const WorldSnapshot& world) const {
  Box column = object.bounds_W();
  const double bottom = column.min.z();
  column.min.z() = -1;
  const auto riders = standing_on(object, world);
  double height = world.table.max.z();
  for (const auto& other : world.objects) {
    const bool rides = other.name == object.name || std::find(riders.begin(), riders.end(), other.name) != riders.end();
    if (!rides && overlap_depth(column, other.bounds_W()) > 0.001 && other.bounds_W().max.z() < bottom + 0.01)
      height = std::max(height, other.bounds_W().max.z());
  }
  return height;
}

/// Whether an object can be slid to its goal without meeting others.
bool Avatar::way_is_free(const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world) const {
  constexpr double margin_m = 0.003, step_m = 0.005;
  if (std::abs(p_WG.z() - object.p_WO.z()) > 0.005) return false;
  const Box at_start = object.bounds_W();
  const int steps = static_cast<int>(std::ceil((p_WG - object.p_WO).norm() / step_m));
  for (int i = 0; i <= steps; ++i) {
    const Vec3 by = (p_WG - object.p_WO) * (steps ? static_cast<double>(i) / steps : 1.0);
    for (const auto& other : world.objects) {
      if (other.name == object.name) continue;
      // It may touch what it shall lie beside, and what it leaves.
      Box box = other.bounds_W();
      const double margin = other.name == command_.goal.landmark || i * step_m < 0.02 ? -margin_m : margin_m;
      box.min -= Vec3(margin, margin, -margin_m);
      box.max += Vec3(margin, margin, -margin_m);
      if (overlap_depth({at_start.min + by, at_start.max + by}, box) > 0) return false;
    }
  }
  return true;
}

// ---- Motion --------------------------------------------------------------------------------------------------------

bool Avatar::go(const std::vector<Pose>& X_WT, const Pace& pace) {
  auto path = HandPath::plan(physics_.arm(), target_.hinges.q, X_WT, pace);
  if (!path) return false;
  path_ = std::move(*path);
  path_s_ = 0;
  leftover_qdot_ = target_.hinges.qdot;
  return true;
}

void Avatar::stop_here() {
  path_ = HandPath::stay(target_.hinges.q);
  path_s_ = 0;
  leftover_qdot_.setZero();
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
  if (busy_ && phase_ended()) {
    phases_.pop_front();
    begin_phase();
  }
  phase_s_ += dt_s_;
  path_s_ += dt_s_;
  target_.hinges = path_.at(path_s_);
  if (path_s_ < fade_s) {
    const double left = 1 - path_s_ / fade_s;
    target_.hinges.q += leftover_qdot_ * path_s_ * left * left * left;
    target_.hinges.qdot += leftover_qdot_ * left * left * (left - 3 * path_s_ / fade_s);
  }
  const double step_m = finger_m_per_s * dt_s_;
  target_.opening_m += std::clamp(wanted_opening_m_ - target_.opening_m, -step_m, step_m);
  return target_;
}

// ---- Phases --------------------------------------------------------------------------------------------------------

void Avatar::begin_phase() {
  phase_s_ = 0;
  steps_so_ = 0;
  if (phases_.empty()) {
    end_act();
    return;
  }
  const WorldSnapshot world = physics_.snapshot({});
  const int held = physics_.held();
  bool possible = true;
  switch (phases_.front()) {
    case Phase::hover:
      if (world.held.empty()) wanted_opening_m_ = command_.what == Capability::point ? 0 : resting_opening_m;
      possible = go(over(hover_pose(world), world));
      break;
    case Phase::approach:
      wanted_opening_m_ = grip_.opening_m;
      possible = go(over(fingers_down(world.objects[object_].p_WO + grip_.p_OT, grip_.yaw), world));
      break;
    case Phase::close:
      physics_.set_grip(object_);
      release_opening_m_ = grip_.opening_m;
      wanted_opening_m_ = 0;
      break;
    case Phase::raise:
      possible = go({hand_for_object(p_WG_, grip_.yaw)}, loaded);
      break;
    case Phase::carry: {
      constexpr double above_m = 0.01, drag_m = 0.001;
      const Vec3 first_at = set_down_.shove_from_W.value_or(set_down_.p_WO);
      along_table_ = command_.what == Capability::slide && way_is_free(world.objects[object_], first_at, world);
      const Vec3 above(0, 0, along_table_ ? drag_m : above_m);
      const Pose at_goal = hand_for_object(first_at + above, grip_.yaw + grip_.turn);
      possible = along_table_ ? go({at_goal}, loaded) : go(over(at_goal, world), loaded);
      break;
    }
    case Phase::lower: {
      // A little further than it should be needed: contact ends the phase.
      constexpr double further_m = 0.003;
      if (held < 0) break;
      const ObjectState& object = world.objects[held];
      const double down = object.bounds_W().min.z() - height_under(object, world) + further_m;
      Pose X_WT = tool_pose(physics_.arm(), target_.hinges.q);
      X_WT.p_WB.z() -= std::max(0.0, down);
      possible = go({X_WT}, gentle);
      break;
    }
    case Phase::shove: {
      Vec3 p_WO = set_down_.p_WO;
      if (held >= 0) p_WO.z() = physics_.object_pose(held).p_WB.z();
      possible = held != object_ || go({hand_for_object(p_WO, grip_.yaw + grip_.turn)}, gentle);
      break;
    }
    case Phase::open:
      stop_here();
      physics_.set_grip(-1);
      wanted_opening_m_ = std::max(release_opening_m_, target_.opening_m);
      break;
    case Phase::retreat: {
      Pose X_WT = tool_pose(physics_.arm(), target_.hinges.q);
      X_WT.p_WB.z() += 0.09;
      possible = go({X_WT});
      break;
    }
    case Phase::go_home:
      path_ = HandPath::between(target_.hinges.q, physics_.arm().home);
      path_s_ = 0;
      break;
    case Phase::settle:
      break;
  }
  if (!possible) fail(Status::unreachable, "the arm does not get there");
}

bool Avatar::phase_ended() {
  if (phases_.empty()) return false;
  const int held = physics_.held();
  switch (phases_.front()) {
    case Phase::hover:
    case Phase::retreat:
    case Phase::go_home:
      return arrived();
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
      // Pressing by position, not by force: what is between the fingers then has a place there.
      if (steps_so_ == 1) wanted_opening_m_ = std::max(0.0, target_.opening_m - squeeze_m);
      if (steps_so_ >= firm_steps) return true;
      if (phase_s_ > patience_s) fail(Status::blocked, "the fingers found no hold");
      return false;
    }
    case Phase::raise:
    case Phase::carry:
      if (held != object_) {
        fail(Status::dropped, fmt::format("{} slipped out of the fingers", command_.object));
        return false;
      }
      if (pushes_hard()) {
        fail(Status::blocked, fmt::format("something is in {}'s way", command_.object));
        return false;
      }
      return arrived();
    case Phase::shove:
      return held != object_ || arrived();
    case Phase::lower: {
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
      constexpr int still_steps = 25;
      constexpr double patience_s = 1.5;
      steps_so_ = physics_.slower_than(0.01, 0.2) ? steps_so_ + 1 : 0;
      return steps_so_ >= still_steps || phase_s_ > patience_s;
    }
  }
  return true;
}

/// Ends the act badly, but with an open hand clear of things.
void Avatar::fail(Status status, std::string reason) {
  if (outcome_.status == Status::done) {
    outcome_.status = status;
    outcome_.reason = std::move(reason);
  }
  const bool retreating = !phases_.empty() && phases_.front() == Phase::retreat;
  stop_here();
  // By the hinges alone the arm gets home from wherever it is: what it could not do before, it can from there.
  if (retreating || is_gesture(command_.what)) {
    phases_ = {Phase::go_home};
  } else if (physics_.held() >= 0) {
    phases_ = {Phase::lower, Phase::open, Phase::retreat, Phase::go_home, Phase::settle};
  } else {
    phases_ = {Phase::open, Phase::retreat, Phase::go_home, Phase::settle};
  }
  begin_phase();
}

void Avatar::end_act() {
  if (is_move(command_.what) && outcome_.status != Status::unreachable && outcome_.status != Status::blocked &&
      object_ >= 0) {
    outcome_.position_error_m = on_grid((physics_.object_pose(object_).p_WB - p_WG_).head<2>().norm());
    if (outcome_.status == Status::done && outcome_.position_error_m > set_down_error_m) {
      outcome_.status = Status::missed;
      outcome_.reason =
          fmt::format("{} came to lie {:.0f} mm from its goal", command_.object, 1000 * outcome_.position_error_m);
    }
  }
  phases_.clear();
  busy_ = false;
  result_ = outcome_;
}

}  // namespace continua
