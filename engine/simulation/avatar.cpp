#include "simulation/avatar.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "simulation/hand_route.h"
#include "simulation/stacks.h"

namespace continua {

namespace {

using Status = ActReport::Status;

constexpr double set_down_error_m = 0.02;  // beyond it a put has missed
constexpr double room_within_m = 0.012;    // how far from its place a thing may be set down to find room
constexpr int most_attempts = 3, most_preparations = 4;

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
  attempts_ = preparations_ = 0;
  tried_.clear();
  moved_aside_.clear();
  result_.reset();
  if (command.what == Capability::stop) return halt();
  busy_ = true;

  const WorldSnapshot world = physics_.snapshot({});
  if (command_.object.empty() && !is_gesture(command_.what)) command_.object = world.held;
  const bool in_hand = !command_.object.empty() && world.held == command_.object;
  lets_go_ = command_.what == Capability::put || (command_.what == Capability::slide && !in_hand);
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

/// Sets out the phases, or ends the act if it cannot be done.
void Avatar::decide() {
  const WorldSnapshot world = physics_.snapshot({});
  const auto cannot = [&](Status status, std::string reason) {
    // What has failed before remains the reason of the failure.
    if (outcome_.status == Status::done) outcome_ = {0, {}, status, 0, std::move(reason)};
    end_act();
  };
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
      return cannot(Status::unreachable, "the arm does not reach there");
    phases_ = {Phase::hover};
  } else if (command_.what == Capability::ungrasp) {
    object_ = physics_.held();
    if (object_ >= 0) phases_ = {Phase::lower, Phase::open, Phase::retreat, Phase::settle};
  } else if (command_.object.empty()) {
    return cannot(Status::blocked, "there is nothing in the hand");
  } else if (!world.held.empty() && world.held != command_.object) {
    // What is in the hand is put away before it is decided how to go about the other object.
    return put_away(world);
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
  const auto cannot = [&](Status status, std::string reason) {
    if (outcome_.status == Status::done) outcome_ = {0, {}, status, 0, std::move(reason)};
    end_act();
  };
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
                                           ? "the arm does not reach the goal"
                                           : fmt::format("the arm does not reach {}", object.name));
  }
  if (outcome_.status != Status::done) {
    ++attempts_;
    outcome_ = {};
  }
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

void Avatar::begin_handling(const Handling& handling, bool in_hand) {
  handling_ = handling;
  object_ = index_of(handling.object, physics_.snapshot({}));
  if (!in_hand) phases_ = {Phase::approach, Phase::close};
  const bool preparing = stage_ == Stage::preparation;
  if (handling.set_down && (preparing || is_move(command_.what))) {
    phases_.insert(phases_.end(), {Phase::carry, handling.into.empty() ? Phase::lower : Phase::insert});
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
  if (outcome_.status == Status::done || is_gesture(command_.what) || command_.what == Capability::ungrasp ||
      attempts_ + 1 >= most_attempts)
    return false;
  if (stage_ == Stage::act) tried_.push_back(handling_.grip);
  decide();
  return true;
}

/// Whether the object has come to be in the hollow of a container.
bool Avatar::is_in(const std::string& container, const WorldSnapshot& world) const {
  const std::array landmarks = {*Landmark::named(container, world)};
  return holds_by(Relation::in, *world.find(command_.object), landmarks, world.table, Perspective::avatar) > 0;
}

/// Measures what has been reached.
void Avatar::judge() {
  if (!is_move(command_.what)) return;
  const WorldSnapshot world = physics_.snapshot({});
  const int object = index_of(command_.object, physics_.snapshot({}));
  outcome_.position_error_m = on_grid((physics_.object_pose(object).p_WB - p_WG_).head<2>().norm());
  if (command_.goal.relation == Relation::in) {
    if (is_in(landmark(), world)) return;
  } else if (outcome_.position_error_m <= set_down_error_m) {
    return;
  }
  outcome_.status = Status::missed;
  outcome_.reason =
      fmt::format("{} came to lie {:.0f} mm from its goal", command_.object, 1000 * outcome_.position_error_m);
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
  phases_.clear();
  if (path_s_ < path_.duration_s()) stop_here();
  busy_ = false;
  outcome_.moved_aside = moved_aside_;
  result_ = outcome_;
}

}  // namespace continua
