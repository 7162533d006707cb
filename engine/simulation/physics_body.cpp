#include "simulation/physics_body.h"

#include <algorithm>

namespace continua {

namespace {

// Slower than this for so long is at rest. Contacts creep by some micrometres per second, which is not motion.
constexpr double rest_m_per_s = 2e-3, rest_rad_per_s = 0.05;
constexpr SimTime rest_after{100'000};

constexpr SimTime sample_every{33'334};  // at most 30 per second
constexpr double turn_grid = 1e-3;       // radians

bool differs(const Pose& a, const Pose& b) {
  return (a.p_WB - b.p_WB).cwiseAbs().maxCoeff() > position_grid_m || a.R_WB.angularDistance(b.R_WB) > turn_grid;
}

bool at_once(Capability what) { return what == Capability::look || what == Capability::signal; }
bool gesture(Capability what) { return what == Capability::reach || what == Capability::point; }

}  // namespace

Result<std::unique_ptr<PhysicsBody>> PhysicsBody::create(const Scene& scene) {
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

/// After the simulation diverged: back to when the world was last at rest, and at rest again.
void PhysicsBody::set_back() {
  physics_->restore();
  avatar_.abandon("the simulation diverged; the world has been set back to when it was last at rest");
  still_steps_ = static_cast<int>(rest_after.us / step_.us) + 1;
}

WorldReport PhysicsBody::advance(SimTime t) {
  WorldReport report;
  begin_acts(report);
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
    finish_act(report, now_);
    begin_acts(report);
    sample(report);
  }
  told_until_ = std::max(told_until_, t);
  return report;
}

/// Begins what need not wait.
void PhysicsBody::begin_acts(WorldReport& report) {
  const SimTime t = std::max(now_, told_until_);
  const auto is_at_once = [](const AvatarCommand& command) { return at_once(command.what); };
  for (auto it = std::find_if(waiting_.begin(), waiting_.end(), is_at_once); it != waiting_.end();
       it = std::find_if(waiting_.begin(), waiting_.end(), is_at_once)) {
    report.acts.push_back({it->id, t, ActReport::Status::started, 0, ""});
    report.acts.push_back({it->id, t, ActReport::Status::done, 0, ""});
    waiting_.erase(it);
  }
  while (!waiting_.empty()) {
    const AvatarCommand next = waiting_.front();
    if (avatar_.busy()) {
      if (!avatar_.may_be_superseded() || !gesture(next.what)) return;
      report.acts.push_back({act_id_, t, ActReport::Status::done, 0, "superseded by a newer act"});
    }
    // What stands still is worth coming back to.
    if (is_still()) physics_->save();
    waiting_.pop_front();
    act_id_ = next.id;
    still_steps_ = 0;
    report.acts.push_back({next.id, t, ActReport::Status::started, 0, ""});
    avatar_.begin(next);
    finish_act(report, t);
  }
}

void PhysicsBody::finish_act(WorldReport& report, SimTime t) {
  auto result = avatar_.take_result();
  if (!result) return;
  result->id = act_id_;
  result->t = t;
  report.acts.push_back(std::move(*result));
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
