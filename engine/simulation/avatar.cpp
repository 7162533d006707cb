#include "simulation/avatar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "simulation/hand_route.h"
#include "simulation/stacks.h"
#include "simulation/turning.h"

namespace continua {

namespace {

using Status = ActReport::Status;

constexpr double turned_wrong = 0.17;  // radians: beyond it a turn has missed
// One retry of what failed in the world; that the arm finds no way with a grip, two more grips may mend.
constexpr int most_retries = 1, most_detours = 2;

ObjectShapes shapes_of(const std::vector<SceneObject>& objects) {
  ObjectShapes shapes;
  for (const auto& object : objects) shapes[object.name] = object.shape;
  return shapes;
}

}  // namespace

bool is_gesture(Capability what) { return what == Capability::reach || what == Capability::point; }

Avatar::Avatar(Physics& physics)
    : physics_(physics),
      dt_s_(physics.timestep_s()),
      shapes_(shapes_of(physics.objects())),
      means_{physics.avatar(), shapes_},
      path_(HandPath::stay(physics.hinges())) {
  wanted_opening_m_ = target_.opening_m = resting_opening_m;
  target_.hinges = {physics.hinges(), ArmVector::Zero(physics.arm().size())};
  leftover_qdot_ = behind_q_ = target_.hinges.qdot;
}

int Avatar::index_of(const std::string& object) const {
  const auto& objects = physics_.objects();
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const auto& one) { return one.name == object; });
  return found == objects.end() ? -1 : static_cast<int>(found - objects.begin());
}

bool Avatar::may_be_superseded() const { return busy_ && is_gesture(command_.what); }

std::optional<ActReport> Avatar::take_result() { return std::exchange(result_, std::nullopt); }

void Avatar::begin(const AvatarCommand& command) {
  command_ = command;
  outcome_ = {};
  retried_ = detours_ = preparations_ = pushes_ = 0;
  tried_.clear();
  moved_aside_.clear();
  retries_.clear();
  let_go_.reset();
  yaw_WG_.reset();
  result_.reset();
  if (command.what == Capability::stop) return halt();
  busy_ = true;
  if (command.what == Capability::retract) {
    stage_ = Stage::act;
    phases_ = {Phase::withdraw, Phase::go_home};
    return begin_phase();
  }

  const WorldSnapshot world = physics_.snapshot({});
  if (command_.object.empty() && !is_gesture(command_.what)) command_.object = world.held;
  const bool in_hand = !command_.object.empty() && world.held == command_.object;
  lets_go_ = command_.what == Capability::put ||
             ((command_.what == Capability::slide || command_.what == Capability::turn) && !in_hand);
  if (command_.what == Capability::grasp && command_.next) command_.goal = *command_.next;
  if (command_.what == Capability::grasp && in_hand) return end_act();
  if (command_.what == Capability::move && !in_hand) {
    outcome_.status = Status::blocked;
    outcome_.reason = command_.object.empty() ? "there is nothing in the hand"
                                              : fmt::format("{} is not in the hand", command_.object);
    return end_act();
  }
  decide();
}

/// Whatever is under way ends where it is; what the fingers hold they keep, and what they do not yet hold they leave.
void Avatar::halt() {
  if (!busy_) return end_act();
  if (!phases_.empty() && phases_.front() == Phase::close) {
    if (physics_.held() >= 0) {
      if (steps_so_ == 0) hold_firmly();
    } else {
      physics_.set_grip(-1);
      wanted_opening_m_ = release_opening_m_;
    }
  }
  brake();
  failing_ = false;
  stage_ = Stage::act;
  phases_ = {Phase::halt};
  begin_phase();
}

void Avatar::abandon(std::string reason) {
  target_.hinges.q = physics_.hinges();
  stop_here();
  if (!busy_) return;
  outcome_ = {};
  outcome_.status = Status::dropped;
  outcome_.reason = std::move(reason);
  end_act();
}

/// When nothing of a handling remains to be done.
void Avatar::phases_done() {
  if (command_.what == Capability::stop) return end_act();
  if (outcome_.status == Status::done && stage_ == Stage::preparation) return decide();
  if (outcome_.status == Status::done) judge();
  if (!try_again()) end_act();
}

/// Whether the act has failed in a way that another attempt may mend, which then has begun.
bool Avatar::try_again() {
  const bool once =
      is_gesture(command_.what) || command_.what == Capability::ungrasp || command_.what == Capability::retract;
  const bool spent = outcome_.status == Status::unreachable ? detours_ >= most_detours : retried_ >= most_retries;
  if (outcome_.status == Status::done || once || spent) return false;
  if (stage_ == Stage::act) tried_.push_back(handling_.grip);
  decide();
  return true;
}

/// Whether the object stands in the relation that was asked for. A step to a side of its own is a place.
bool Avatar::is_related(const WorldSnapshot& world) const {
  const Goal& goal = command_.goal;
  std::vector<Landmark> landmarks;
  for (const auto& name : goal.landmarks) {
    if (name == command_.object) return true;
    landmarks.push_back(*Landmark::named(name, world));
  }
  return !goal.relation ||
         holds_by(*goal.relation, *world.find(command_.object), landmarks, world.table, goal.perspective) > 0;
}

/// Whether what was let go of has moved since, or moves still.
bool Avatar::moved_again() const {
  constexpr double moved_m = 0.01, tipped_rad = 0.2;
  // What only trembles where it stands has not moved.
  constexpr double trembles_m = 1e-3, trembles_rad = 0.02;
  if (!let_go_) return false;
  const Pose X_WO = physics_.object_pose(let_go_->object);
  const auto farther = [&](double m, double rad) {
    return (X_WO.p_WB - let_go_->X_WO.p_WB).norm() > m || X_WO.R_WB.angularDistance(let_go_->X_WO.R_WB) > rad;
  };
  if (quiet_steps_ * dt_s_ < quiet_s && farther(trembles_m, trembles_rad)) return true;
  // What was let fall into a hollow moves until it lies there.
  const WorldSnapshot world = physics_.snapshot({});
  const ObjectState& object = world.objects[static_cast<std::size_t>(let_go_->object)];
  for (const auto& other : world.objects) {
    const std::array landmarks = {Landmark::object(other)};
    if (other.interior && other.name != object.name &&
        holds_by(Relation::in, object, landmarks, world.table, Perspective::avatar) > 0)
      return false;
  }
  return farther(moved_m, tipped_rad);
}

/// Measures what has been reached.
void Avatar::judge() {
  const auto failed = [&](Status status, std::string reason) {
    outcome_.status = status;
    outcome_.reason = std::move(reason);
  };
  const bool turning = command_.what == Capability::turn;
  const WorldSnapshot world = physics_.snapshot({});
  if (moves_to_goal(command_.what) || turning) {
    const int object = index_of(command_.object);
    const auto shape = shapes_.find(command_.object);
    const bool is_round = shape != shapes_.end() && shape->second.is_round();
    outcome_.position_error_m = on_grid((physics_.object_pose(object).p_WB - p_WG_).head<2>().norm());
    if (yaw_WG_ && !is_round) {
      constexpr double full_turn = 6.283185307179586, yaw_grid = 1e-3;
      const double off = std::remainder(world.find(command_.object)->yaw - *yaw_WG_, full_turn);
      outcome_.yaw_error = yaw_grid * std::round(off / yaw_grid);
    }
  }
  if (moved_again())
    return failed(Status::unstable, fmt::format("{} moved again within a second", world.objects[let_go_->object].name));
  if (turning && std::abs(outcome_.yaw_error) > turned_wrong)
    return failed(Status::missed, fmt::format("{} came to be turned {:.0f} degrees too far or too little",
                                              command_.object, 57.29577951308232 * std::abs(outcome_.yaw_error)));
  // Where in a hollow it comes to lie does not matter.
  const bool inside = moves_to_goal(command_.what) && command_.goal.relation == Relation::in;
  if (!inside && outcome_.position_error_m > set_down_error_m)
    return failed(Status::missed, fmt::format("{} came to lie {:.0f} mm from its goal", command_.object,
                                              1000 * outcome_.position_error_m));
  if (moves_to_goal(command_.what) && !is_related(world))
    failed(Status::missed, fmt::format("{} did not come to be {} {}", command_.object,
                                       in_words(*command_.goal.relation), fmt::join(command_.goal.landmarks, " and ")));
}

/// Ends the handling badly, but with an open hand clear of things.
void Avatar::fail(Status status, std::string reason) {
  if (outcome_.status == Status::done) {
    outcome_.status = status;
    outcome_.reason = std::move(reason);
  }
  failing_ = true;
  const bool retreating = !phases_.empty() && phases_.front() == Phase::retreat;
  stop_here();
  // By the hinges alone the arm gets home from wherever it is: what it could not do before, it can from there.
  if (retreating || is_gesture(command_.what) || command_.what == Capability::retract) {
    phases_ = {Phase::go_home};
  } else if (physics_.held() >= 0) {
    phases_ = {Phase::lower, Phase::open, Phase::retreat, Phase::go_home, Phase::settle};
  } else {
    phases_ = {Phase::open, Phase::retreat, Phase::go_home, Phase::settle};
  }
  begin_phase();
}

void Avatar::end_act() {
  phases_.clear();
  if (path_s_ < path_.duration_s()) stop_here();
  busy_ = false;
  outcome_.moved_aside = moved_aside_;
  outcome_.retries = retries_;
  const bool handles = !is_gesture(command_.what) && command_.what != Capability::stop;
  const std::string object = command_.what == Capability::ungrasp && let_go_
                                 ? physics_.objects()[static_cast<std::size_t>(let_go_->object)].name
                                 : command_.object;
  const int handled = handles ? index_of(object) : -1;
  if (handled >= 0) outcome_.touches = physics_.touched_by(handled);
  result_ = outcome_;
}

}  // namespace continua
