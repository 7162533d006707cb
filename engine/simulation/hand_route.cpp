#include "continua/simulation/hand_route.h"

#include <algorithm>
#include <cmath>

#include "continua/core/angles.h"
#include "continua/simulation/stacks.h"

namespace continua {

namespace {

constexpr double clearance_m = 0.025;  // between a moving thing and the things below it

bool overlap(const Box& a, const Box& b) { return (a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min)).minCoeff() > 0; }

/// Reach of hand and held object below the point between the pads.
double reach_below(const ObjectState* held, const Pose& X_WT, const HandShape& hand) {
  return std::max(hand.finger_tip_m, held ? X_WT.p_WB.z() - held->bounds_W().min.z() : 0.0);
}

}  // namespace

Pose before_grasp(const Pose& X_WT) {
  // Fingers and half a palm above the highest things that are grasped; from below an edge, out from under it.
  constexpr double above_m = 0.09, back_m = 0.06;
  if (is_level(X_WT.R_WB)) return {X_WT.p_WB + Vec3(0, 0, above_m), X_WT.R_WB};
  return {X_WT.p_WB - back_m * (X_WT.R_WB * Vec3::UnitX()), X_WT.R_WB};
}

std::vector<Pose> way_to_grasp(const Pose& X_WF, const Pose& X_WT, const WorldSnapshot& world,
                               const AvatarForm& avatar) {
  if (is_level(X_WT.R_WB)) return way_over(X_WF, X_WT, world, avatar);
  auto poses = way_over(X_WF, before_grasp(X_WT), world, avatar);
  poses.push_back(X_WT);
  return poses;
}

std::vector<Pose> way_over(const Pose& X_WF, const Pose& X_WT, const WorldSnapshot& world, const AvatarForm& avatar,
                           double below_m) {
  constexpr double hand_half_m = 0.07;  // the hand and some air to either side of its way
  // Smaller differences of the hand's turn are made on the straight way, smaller distances need no way above.
  constexpr double wrist_turn = 1, hand_turn = 0.8, far_m = 0.01;
  const HandTurn from = turn_of(X_WF.R_WB), to = turn_of(X_WT.R_WB);
  const double lean = std::max(std::abs(std::sin(from.tilt)), std::abs(std::sin(to.tilt)));
  const double wide_m = hand_half_m + avatar.hand.palm_back_m * lean;
  const Box way{X_WF.p_WB.cwiseMin(X_WT.p_WB) - Vec3(wide_m, wide_m, 1),
                X_WF.p_WB.cwiseMax(X_WT.p_WB) + Vec3(wide_m, wide_m, 1)};

  const ObjectState* held = world.find(world.held);
  double top = world.table.max.z();
  for (const auto& other : world.objects) {
    if (&other == held) continue;
    const Box box = other.bounds_W();
    const auto carried = held ? standing_on(*held, world) : std::vector<std::string>();
    if (std::find(carried.begin(), carried.end(), other.name) == carried.end() && overlap(box, way))
      top = std::max(top, box.max.z());
  }
  const double height = top + std::max(below_m, reach_below(held, X_WF, avatar.hand)) + clearance_m;

  // The wrist turns within its limits on the way: the last hinge may be unable to make the hand's shortest turn.
  const double from_wrist = std::remainder(from.yaw - avatar.natural_yaw(X_WF.p_WB), full_turn);
  const double to_wrist = std::remainder(to.yaw - avatar.natural_yaw(X_WT.p_WB), full_turn);
  const bool turns = std::abs(to_wrist - from_wrist) > wrist_turn || std::abs(to.tilt - from.tilt) > hand_turn ||
                     std::abs(to.roll - from.roll) > hand_turn;
  const bool far = (X_WF.p_WB - X_WT.p_WB).head<2>().norm() > far_m;

  std::vector<Pose> poses;
  const Vec3 start(X_WF.p_WB.x(), X_WF.p_WB.y(), std::max(height, X_WF.p_WB.z()));
  const Vec3 end(X_WT.p_WB.x(), X_WT.p_WB.y(), std::max(height, X_WT.p_WB.z()));
  if ((far || turns) && X_WF.p_WB.z() < height) poses.push_back({start, X_WF.R_WB});
  if (turns) {
    for (const double s : {0.25, 0.5, 0.75}) {
      const Vec3 p = start + s * (end - start);
      const double yaw = avatar.natural_yaw(p) + from_wrist + s * (to_wrist - from_wrist);
      poses.push_back(
          {p, rotation({yaw, from.tilt + s * (to.tilt - from.tilt), from.roll + s * (to.roll - from.roll)})});
    }
  }
  if ((far || turns) && X_WT.p_WB.z() < height) poses.push_back({end, X_WT.R_WB});
  poses.push_back(X_WT);
  return poses;
}

Pose hover_pose(const ObjectState* object, const Vec3& p_W, const WorldSnapshot& world, const Pose& X_WT,
                const AvatarForm& avatar) {
  constexpr double hover_m = 0.05, step_m = 0.01, highest_m = 0.5;
  const ObjectState* held = world.find(world.held);
  // The fingers close along the side of the object for which the wrist turns least.
  const double natural = avatar.natural_yaw(p_W);
  const double yaw = object ? object->yaw + quarter_turn * std::round((natural - object->yaw) / quarter_turn) : natural;
  Pose X{p_W + Vec3(0, 0, reach_below(held, X_WT, avatar.hand) + hover_m), rotation({yaw, 0})};
  std::vector<OrientedBox> others;
  for (const auto& other : world.objects) {
    if (&other != held) others.push_back(column_of(other));
  }
  while (X.p_WB.z() < highest_m && hand_conflict(avatar.hand, X, resting_opening_m, others) > 0) X.p_WB.z() += step_m;
  return X;
}

std::vector<OrientedBox> things_around(const WorldSnapshot& world) {
  std::vector<OrientedBox> things{table_block(world.table)};
  for (const auto& object : world.objects)
    if (object.name != world.held) things.push_back(box_of(object));
  return things;
}

std::vector<Pose> pointing_poses(const Vec3& p_W, const Vec3& base_W) {
  const Vec3 eye_W = base_W + Vec3(0, 0, 0.15);  // height of a head: fingers and gaze go the same way
  std::vector<Pose> poses;
  for (const double distance_m : {0.1, 0.15, 0.2, 0.3}) {
    for (const double steeper : {0.0, 0.3, 0.6}) {
      const Vec3 x = ((1 - steeper) * (p_W - eye_W).normalized() - steeper * Vec3::UnitZ()).normalized();
      const Vec3 y = Vec3::UnitZ().cross(x).normalized();
      Eigen::Matrix3d R;
      R << x, y, x.cross(y);
      poses.push_back({p_W - distance_m * x, Eigen::Quaterniond(R)});
    }
  }
  return poses;
}

std::optional<std::string> met_on_way(const ObjectState& object, const Vec3& p_WG, const std::string& landmark,
                                      const WorldSnapshot& world) {
  constexpr double margin_m = 0.003;  // air beside a thing that it passes
  constexpr double step_m = 0.005;    // of the way: less than any thing is wide
  constexpr double leaving_m = 0.02;  // at the beginning it may touch what it leaves
  const Vec3 way = p_WG - object.p_WO;
  const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / step_m)));
  for (int i = 0; i <= steps; ++i) {
    OrientedBox box = box_of(object);
    box.center_W += way * i / steps;
    for (const ObjectState* other : apart_from(object, world)) {
      // Touching the landmark is allowed, and its old neighbours at the beginning.
      const bool may_touch = other->name == landmark || i * step_m < leaving_m;
      OrientedBox theirs = box_of(*other);
      theirs.half_m += Vec3(may_touch ? -margin_m : margin_m, may_touch ? -margin_m : margin_m, -margin_m);
      if (overlap_depth(box, theirs) > 0) return other->name;
    }
  }
  return std::nullopt;
}

bool way_is_free(const ObjectState& object, const Vec3& p_WG, const std::string& landmark, const WorldSnapshot& world) {
  constexpr double level_m = 0.005;
  return std::abs((p_WG - object.p_WO).z()) <= level_m && !met_on_way(object, p_WG, landmark, world);
}

}  // namespace continua
