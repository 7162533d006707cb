#include "continua/simulation/physics_body.h"

#include <algorithm>

#include "continua/simulation/world_pace.h"

namespace continua {

namespace {

// Lower speeds for this time are rest: contacts creep by some micrometres per second.
constexpr double rest_m_per_s = 2e-3, rest_rad_per_s = 0.05;
constexpr SimTime rest_after{100'000};

constexpr SimTime sample_every{33'334};  // at most 30 per second
constexpr double turn_grid = 1e-3;       // radians

bool is_stop(const AvatarCommand& command) { return command.what == Capability::stop; }

bool differs(const Pose& a, const Pose& b) {
  return (a.p_WB - b.p_WB).cwiseAbs().maxCoeff() > position_grid_m || a.R_WB.angularDistance(b.R_WB) > turn_grid;
}

}  // namespace

Result<std::unique_ptr<PhysicsBody>> PhysicsBody::create(const Scene& scene) {
  if (auto slow = check_pace(scene)) return *std::move(slow);
  auto physics = Physics::create(scene);
  if (!physics) return physics.error();
  return std::unique_ptr<PhysicsBody>(new PhysicsBody(std::move(*physics)));
}

PhysicsBody::PhysicsBody(std::unique_ptr<Physics> physics)
    : physics_(std::move(physics)), avatar_(*physics_), step_(SimTime::from_seconds(physics_->timestep_s())) {
  for (const auto& [name, pose] : physics_->poses()) last_poses_[name] = pose;
}

void PhysicsBody::command(const AvatarCommand& command) { waiting_.push_back(command); }

WorldSnapshot PhysicsBody::snapshot() const { return physics_->snapshot(told_until_); }

bool PhysicsBody::at_rest() const { return waiting_.empty() && is_still(); }

bool PhysicsBody::is_still() const { return !avatar_.busy() && still_steps_ * step_.us >= rest_after.us; }

/// Returns to the last rest, after a divergence.
void PhysicsBody::set_back() {
  physics_->restore();
  avatar_.abandon({ReasonCode::diverged});
  still_steps_ = static_cast<int>(rest_after.us / step_.us) + 1;
}

WorldReport PhysicsBody::advance(SimTime t) {
  WorldReport report;
  report.until = std::max(told_until_, t);
  if (begin_acts(report)) {
    report.until = told_until_ = std::max(told_until_, now_);
    return report;
  }
  while (true) {
    if (at_rest()) {
      if (now_ < t) report.rests.push_back({now_, t});
      now_ = std::max(now_, t);
      break;
    }
    if (now_ + step_ > t) break;
    const bool stepped = physics_->step(avatar_.update());
    now_ = now_ + step_;
    if (!stepped)
      set_back();
    else
      still_steps_ = !avatar_.busy() && physics_->slower_than(rest_m_per_s, rest_rad_per_s) ? still_steps_ + 1 : 0;
    const bool ended = finish_act(report, now_);
    sample(report);
    if (ended) {
      report.until = now_;
      break;
    }
  }
  told_until_ = report.until;
  return report;
}

/// Begins the acts that need not wait. True if an act has begun or ended.
bool PhysicsBody::begin_acts(WorldReport& report) {
  const SimTime t = std::max(now_, told_until_);
  const auto announced = [](const AvatarCommand& command) { return effect_of(command.what) == ActEffect::announced; };
  for (auto it = std::find_if(waiting_.begin(), waiting_.end(), announced); it != waiting_.end();
       it = std::find_if(waiting_.begin(), waiting_.end(), announced)) {
    report.acts.push_back({it->id, t, ActReport::Status::started, 0, {}});
    report.acts.push_back({it->id, t, ActReport::Status::done, 0, {}});
    waiting_.erase(it);
  }
  if (std::any_of(waiting_.begin(), waiting_.end(), is_stop)) {
    begin_stop(report, t);
    finish_act(report, t);
    return true;
  }
  if (waiting_.empty()) return !report.acts.empty();
  const AvatarCommand command = waiting_.front();
  if (avatar_.busy()) {
    if (!avatar_.may_be_superseded() || !is_gesture(command.what)) return !report.acts.empty();
    report.acts.push_back({act_id_, t, ActReport::Status::done, 0, {ReasonCode::superseded}});
  }
  waiting_.pop_front();
  begin_act(command, report, t);
  finish_act(report, t);
  return true;
}

/// Cancels everything before the last stop, and begins that stop.
void PhysicsBody::begin_stop(WorldReport& report, SimTime t) {
  if (avatar_.busy()) report.acts.push_back({act_id_, t, ActReport::Status::stopped, 0, {}});
  while (std::count_if(waiting_.begin(), waiting_.end(), is_stop) > 1 || !is_stop(waiting_.front())) {
    report.acts.push_back({waiting_.front().id, t, ActReport::Status::stopped, 0, {}});
    waiting_.pop_front();
  }
  const AvatarCommand stop = waiting_.front();
  waiting_.pop_front();
  begin_act(stop, report, t);
}

void PhysicsBody::begin_act(const AvatarCommand& command, WorldReport& report, SimTime t) {
  // A world at rest is worth a return after a divergence.
  if (is_still()) physics_->save();
  act_id_ = command.id;
  still_steps_ = 0;
  report.acts.push_back({command.id, t, ActReport::Status::started, 0, {}});
  avatar_.begin(command);
}

/// Reports the end of the act under way. True if it has ended.
bool PhysicsBody::finish_act(WorldReport& report, SimTime t) {
  auto result = avatar_.take_result();
  if (!result) return false;
  result->id = act_id_;
  result->t = t;
  report.acts.push_back(std::move(*result));
  return true;
}

void PhysicsBody::sample(WorldReport& report) {
  if (last_sample_ && now_ < *last_sample_ + sample_every) return;
  PoseSample sample{now_, {}};
  for (const auto& [name, pose] : physics_->poses()) {
    if (!differs(pose, last_poses_[name])) continue;
    last_poses_[name] = pose;
    sample.bodies[name] = {on_grid(pose.p_WB), pose.R_WB};
  }
  last_sample_ = now_;
  if (!sample.bodies.empty()) report.poses.push_back(std::move(sample));
}

}  // namespace continua
