#include "continua/simulation/arm_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/angles.h"
#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/hand_route.h"
#include "continua/simulation/motion.h"
#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/physics.h"
#include "continua/simulation/scene_compile.h"
#include "continua/simulation/world_pace.h"

namespace continua {

namespace {

using Notes = std::vector<std::string>;

void note_pads(const mjModel& model, const AvatarElements& ids, Notes& notes) {
  for (const int pad : ids.pad) {
    int count = 0;
    double ahead_m = 0;
    for (const auto& one : ids.before_pads) {
      if (one.pad != pad) continue;
      ++count;
      ahead_m = std::max(ahead_m, one.ahead_m);
    }
    if (count > 0)
      notes.push_back(
          fmt::format("the finger of geom '{}' has {} of its geoms in front of it, by up to {:.1f} mm: things "
                      "pass through there, so that the pad touches them",
                      name_of(model, mjOBJ_GEOM, pad), count, 1000 * ahead_m));
  }
}

/// The hand, its fingers down, gets from home to a place, and not only there.
bool gets_to(const AvatarForm& avatar, const Vec3& p_W) {
  const Pose X_WT{p_W, rotation({avatar.natural_yaw(p_W), 0})};
  return HandPath::plan(avatar.arm, avatar.arm.home, {before_grasp(X_WT), X_WT}).has_value();
}

/// Places spread over the table.
std::vector<Vec3> places_on(const Box& table) {
  constexpr int across = 5, along = 3;
  constexpr double margin_m = 0.05, above_m = 0.03;
  std::vector<Vec3> places;
  for (int i = 0; i < across; ++i)
    for (int k = 0; k < along; ++k) {
      const Vec3 part(i / (across - 1.0), k / (along - 1.0), 0);
      const Vec3 margin = Vec3(margin_m, margin_m, 0).cwiseMin((table.max - table.min) / 2);
      const Vec3 low = table.min + margin, high = table.max - margin;
      places.push_back(low + part.cwiseProduct(high - low) + Vec3(0, 0, above_m));
    }
  return places;
}

void note_reach(const Scene& scene, const AvatarForm& avatar, Notes& notes) {
  std::vector<std::string> beyond;
  for (const auto& object : scene.initial_snapshot().objects)
    if (!gets_to(avatar, object.p_WO)) beyond.push_back(object.name);
  if (!beyond.empty())
    notes.push_back(fmt::format("the arm does not get from home to {} with its fingers down", fmt::join(beyond, ", ")));
  const auto places = places_on(scene.table());
  const auto reached =
      std::count_if(places.begin(), places.end(), [&](const Vec3& p_W) { return gets_to(avatar, p_W); });
  const Vec3 base = avatar.arm.base_W();
  if (2 * reached < static_cast<long>(places.size()))
    notes.push_back(
        fmt::format("the arm gets from home to {} of {} places spread over the table; its first hinge is at ({:.2f}, "
                    "{:.2f}, {:.2f})",
                    reached, places.size(), base.x(), base.y(), base.z()));
}

/// The arm's hinges behind the end of a motion, when the avatar takes the motion as ended; nothing if the processor's
/// time is `latest_s` before.
std::optional<ArmVector> left_behind(Physics& physics, const ArmVector& to, double latest_s) {
  constexpr double patience_s = 0.25;  // as of the avatar's own motions
  Motion motion(physics.hinges(), resting_opening_m);
  motion.wanted_opening_m = resting_opening_m;
  motion.follow_from_rest(HandPath::between(physics.hinges(), to));
  while (!motion.is_over_since(patience_s)) {
    if (processor_s() > latest_s) return std::nullopt;
    if (!physics.step(motion.advance(physics.timestep_s()))) break;
  }
  return (physics.hinges() - to).cwiseAbs();
}

/// From home by some degrees of one hinge, to the side on which the hand is higher.
ArmVector raised(const Arm& arm, int hinge) {
  constexpr double turn_rad = 0.4;
  ArmVector best = arm.home;
  double highest = -1;
  for (const double turn : {turn_rad, -turn_rad}) {
    ArmVector q = arm.home;
    const ArmJoint& joint = arm.joints[static_cast<std::size_t>(hinge)];
    q[hinge] = std::clamp(q[hinge] + turn, joint.min, joint.max);
    const double height = tool_pose(arm, q).p_WB.z();
    if (std::abs(q[hinge] - arm.home[hinge]) > turn_rad / 2 && height > highest) best = q, highest = height;
  }
  return best;
}

void note_servos(const Scene& scene, const AvatarElements& ids, double longest_s, Notes& notes) {
  constexpr double much_rad = 0.02;  // a hand half a metre away is off by a centimetre
  const auto name_of_hinge = [&](int hinge) {
    return name_of(scene.model(), mjOBJ_JOINT, scene.model().dof_jntid[ids.dof[static_cast<std::size_t>(hinge)]]);
  };
  auto physics = Physics::create(scene).value();
  const AvatarForm& avatar = physics->avatar();
  const double latest_s = processor_s() + longest_s;
  for (int hinge = 0; hinge < avatar.arm.size(); ++hinge) {
    const ArmVector to = raised(avatar.arm, hinge);
    const auto there = left_behind(*physics, to, latest_s), back = left_behind(*physics, avatar.arm.home, latest_s);
    if (!there || !back) {
      notes.push_back(
          fmt::format("the servos from hinge '{}' on were not tried: at time steps of {} s that takes over "
                      "{} s of a processor",
                      name_of_hinge(hinge), physics->timestep_s(), longest_s));
      return;
    }
    if (const double most = std::max((*there)[hinge], (*back)[hinge]); most > much_rad)
      notes.push_back(fmt::format(
          "the servo of hinge '{}' is sluggish: {:.0f} degrees are left of a turn by {:.0f} when "
          "the avatar takes it as done; more gain or force, or less damping, would help",
          name_of_hinge(hinge), most / rad_per_deg, std::abs(to[hinge] - avatar.arm.home[hinge]) / rad_per_deg));
  }
}

}  // namespace

std::vector<std::string> guesses_about_avatar(const Scene& scene) {
  const auto compiled = compile_scene(scene.path());
  return compiled ? compiled->guesses : Notes();
}

std::vector<std::string> arm_notes(const Scene& scene, double longest_s) {
  const auto avatar = find_avatar(scene.model(), scene.initial_qpos(), scene.path());
  if (!avatar) return {};
  Notes notes;
  note_pads(scene.model(), avatar->second, notes);
  note_reach(scene, avatar->first, notes);
  note_servos(scene, avatar->second, longest_s, notes);
  return notes;
}

}  // namespace continua
