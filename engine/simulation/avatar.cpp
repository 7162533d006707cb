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

constexpr double set_down_error_m = 0.02;  // beyond it a put has missed
constexpr double turned_wrong = 0.17;      // radians: beyond it a turn has missed
// Of what failed in the world: of the puts of all arms in tests/simulation/arms_test.cpp one in 15 needs the second.
// That the arm finds no way with a grip, two more grips may mend.
constexpr int most_retries = 2, most_detours = 2, most_preparations = 4, most_pushes = 8;

/// The object is carried to a goal.
bool is_move(Capability what) {
  return what == Capability::put || what == Capability::slide || what == Capability::move;
}

ObjectShapes shapes_of(const std::vector<SceneObject>& objects) {
  ObjectShapes shapes;
  for (const auto& object : objects) shapes[object.name] = object.shape;
  return shapes;
}

int index_of(const std::string& name, const WorldSnapshot& world) {
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    if (world.objects[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

/// Whether the object has come to be in the hollow of a container.
bool is_in(const ObjectState& object, const std::string& container, const WorldSnapshot& world) {
  const std::array landmarks = {*Landmark::named(container, world)};
  return holds_by(Relation::in, object, landmarks, world.table, Perspective::avatar) > 0;
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
  constexpr double standing_m = 0.005;
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
  return is_move(command_.what) || (command_.what == Capability::grasp && command_.next);
}

std::string Avatar::landmark() const {
  return command_.goal.landmarks.empty() ? std::string() : command_.goal.landmarks.front();
}

Task Avatar::task(const WorldSnapshot& world) const {
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
    task.near_m = 0.9 * set_down_error_m;
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
  object_ = index_of(object.name, world);
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
  object_ = index_of(handling.object, physics_.snapshot({}));
  if (!in_hand) phases_ = {Phase::approach, Phase::close};
  const bool preparing = stage_ == Stage::preparation;
  const bool turning = command_.what == Capability::turn;
  if (handling.set_down && (preparing || turning || is_move(command_.what))) {
    constexpr double standing_m = 0.005;
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

/// Whether what was let go of has moved since, or moves still.
bool Avatar::moved_again() const {
  constexpr double moved_m = 0.01, tipped_rad = 0.2;
  if (!let_go_) return false;
  if (quiet_steps_ * dt_s_ < quiet_s) return true;
  // What was let fall into a hollow moves until it lies there.
  const WorldSnapshot world = physics_.snapshot({});
  const ObjectState& object = world.objects[static_cast<std::size_t>(let_go_->object)];
  for (const auto& other : world.objects)
    if (other.interior && other.name != object.name && is_in(object, other.name, world)) return false;
  const Pose X_WO = physics_.object_pose(let_go_->object);
  return (X_WO.p_WB - let_go_->X_WO.p_WB).norm() > moved_m ||
         X_WO.R_WB.angularDistance(let_go_->X_WO.R_WB) > tipped_rad;
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
    const int object = index_of(command_.object, world);
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
  const bool shall_be_in = moves_to_goal(command_.what) && command_.goal.relation == Relation::in;
  if (shall_be_in ? is_in(*world.find(command_.object), landmark(), world)
                  : outcome_.position_error_m <= set_down_error_m)
    return;
  failed(Status::missed,
         fmt::format("{} came to lie {:.0f} mm from its goal", command_.object, 1000 * outcome_.position_error_m));
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
  const int handled = handles ? index_of(object, physics_.snapshot({})) : -1;
  if (handled >= 0) outcome_.touches = physics_.touched_by(handled);
  result_ = outcome_;
}

}  // namespace continua
