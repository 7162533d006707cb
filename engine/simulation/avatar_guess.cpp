#include "continua/simulation/avatar_guess.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/geom_bounds.h"

namespace continua {

namespace {

/// The model with all joints at zero.
class AtZero {
 public:
  explicit AtZero(const mjModel& model) : model_(model), data_(mj_makeData(&model)) {
    mj_kinematics(&model, data_.get());
  }

  Pose X_WBody(int body) const { return {vec_of(data_->xpos + 3 * body), quat_of(data_->xquat + 4 * body)}; }

  /// Corners of a geom's box in a frame.
  std::vector<Vec3> corners(int geom, const Pose& X_WA) const {
    const GeomBox box = geom_box_B(model_, geom);
    return corners_A(inverse(X_WA) * X_WBody(model_.geom_bodyid[geom]) * box.X_BG, box.half_m);
  }

  Box bounds(int geom, const Pose& X_WA) const {
    const auto all = corners(geom, X_WA);
    Box bounds{all.front(), all.front()};
    for (const Vec3& corner : all) bounds = {bounds.min.cwiseMin(corner), bounds.max.cwiseMax(corner)};
    return bounds;
  }

  Vec3 center_W(int geom) const { return bounds(geom, Pose{}).center(); }

  Vec3 center_W(const std::vector<int>& geoms) const {
    Vec3 sum = Vec3::Zero();
    for (const int geom : geoms) sum += center_W(geom);
    return sum / static_cast<double>(std::max<std::size_t>(1, geoms.size()));
  }

  /// The axis of the slide joint of a body or of the nearest body that carries it; nothing if that joint is no slide.
  std::optional<Vec3> slide_W(int body) const {
    for (; body > 0; body = model_.body_parentid[body]) {
      if (model_.body_jntnum[body] == 0) continue;
      const int joint = model_.body_jntadr[body];
      if (model_.jnt_type[joint] != mjJNT_SLIDE) return std::nullopt;
      return vec_of(data_->xaxis + 3 * joint).normalized();
    }
    return std::nullopt;
  }

 private:
  const mjModel& model_;
  const DataOwner data_;
};

/// Geoms that `chosen` takes, of a body and all that it carries.
template <class Chosen>
std::vector<int> geoms_on(const mjModel& model, int carrier, Chosen chosen) {
  std::vector<int> geoms;
  for (int geom = 0; geom < model.ngeom; ++geom)
    if (is_below(model, model.geom_bodyid[geom], carrier) && chosen(geom)) geoms.push_back(geom);
  return geoms;
}

/// The axis of a body that is nearest to a direction and across another; the direction itself, put across, if no axis
/// is within 30 degrees.
Vec3 axis_near(const Eigen::Quaterniond& R_WB, const Vec3& direction_W, const Vec3& across_W) {
  constexpr double near = 0.866;
  const Vec3 wanted = (direction_W - across_W * across_W.dot(direction_W)).normalized();
  Vec3 best = wanted;
  double nearest = near;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const Vec3 axis_W = R_WB * Vec3(sign * Vec3::Unit(axis));
      if (axis_W.dot(wanted) > nearest && std::abs(axis_W.dot(across_W)) < 1 - near)
        best = axis_W, nearest = axis_W.dot(wanted);
    }
  return (best - across_W * across_W.dot(best)).normalized();
}

}  // namespace

std::optional<std::array<int, 2>> guess_fingers(const mjModel& model, int hand) {
  std::map<int, std::vector<int>> fingers;  // by the body that carries them
  for (int body = 1; body < model.nbody; ++body) {
    const int joint = model.body_jntadr[body];
    if (model.body_jntnum[body] == 1 && model.jnt_type[joint] == mjJNT_SLIDE && model.jnt_limited[joint] &&
        is_below(model, body, hand))
      fingers[model.body_parentid[body]].push_back(body);
  }
  std::optional<std::array<int, 2>> found;
  for (const auto& [carrier, bodies] : fingers) {
    if (bodies.size() != 2) continue;
    if (found) return std::nullopt;
    found = {bodies[0], bodies[1]};
  }
  return found;
}

int carrier_of(const mjModel& model, int body, int other_body) {
  while (!is_below(model, other_body, body)) body = model.body_parentid[body];
  return body;
}

std::optional<int> guess_pad(const mjModel& model, int finger, int other_finger) {
  constexpr double foremost_m = 0.003;
  const AtZero zero(model);
  const auto solid_on = [&](int body) {
    return geoms_on(model, body, [&](int geom) { return is_solid(model, geom); });
  };
  const auto solid = solid_on(finger), solid_there = solid_on(other_finger);
  if (solid.empty() || solid_there.empty()) return std::nullopt;
  const int hand = carrier_of(model, finger, other_finger);
  const Vec3 center_W = zero.center_W(solid), other_W = zero.center_W(solid_there);
  Vec3 in_W = (other_W - center_W).normalized();
  if (const auto slide_W = zero.slide_W(finger)) in_W = *slide_W * (slide_W->dot(in_W) < 0 ? -1 : 1);
  const Pose X_WH = zero.X_WBody(hand);
  const Vec3 out_W = axis_near(X_WH.R_WB, (center_W + other_W) / 2 - X_WH.p_WB, in_W);
  Eigen::Matrix3d R_WF;  // x along the finger, y toward the other one
  R_WF << out_W, in_W, out_W.cross(in_W);
  const Pose X_WF{center_W, Eigen::Quaterniond(R_WF)};

  double tip_m = -1, root_m = 1, front_m = -1;
  for (const int geom : solid) {
    tip_m = std::max(tip_m, zero.bounds(geom, X_WF).max.x());
    root_m = std::min(root_m, zero.bounds(geom, X_WF).min.x());
  }
  const auto in_outer_half = [&](int geom) { return zero.bounds(geom, X_WF).center().x() > (tip_m + root_m) / 2; };
  for (const int geom : solid)
    if (in_outer_half(geom)) front_m = std::max(front_m, zero.bounds(geom, X_WF).max.y());
  std::optional<int> pad;
  double largest_m2 = 0, farthest_m = -1;
  constexpr double as_large = 0.99;  // of faces as large as each other, the one nearest to the tip
  for (const int geom : solid) {
    const Box box = zero.bounds(geom, X_WF);
    const Vec3 size = box.max - box.min;
    if (!in_outer_half(geom) || box.max.y() < front_m - foremost_m) continue;
    const double m2 = size.x() * size.z();
    if (m2 < as_large * largest_m2 || (m2 < largest_m2 / as_large && box.max.x() < farthest_m)) continue;
    pad = geom;
    largest_m2 = m2;
    farthest_m = box.max.x();
  }
  return pad;
}

Pose guess_grip(const mjModel& model, int hand, const std::array<int, 2>& pads) {
  const AtZero zero(model);
  const Vec3 left_W = zero.center_W(pads[0]), right_W = zero.center_W(pads[1]);
  Vec3 closing_W = (left_W - right_W).normalized();
  if (const auto slide_W = zero.slide_W(model.geom_bodyid[pads[0]]))
    closing_W = *slide_W * (slide_W->dot(closing_W) < 0 ? -1 : 1);
  const Pose X_WH = zero.X_WBody(hand);
  const Vec3 p_W = (left_W + right_W) / 2;
  const auto palm = geoms_on(
      model, hand, [&](int geom) { return model.body_weldid[model.geom_bodyid[geom]] == model.body_weldid[hand]; });
  const Vec3 palm_W = palm.empty() ? X_WH.p_WB : zero.center_W(palm);
  const Vec3 out_W = axis_near(X_WH.R_WB, p_W - palm_W, closing_W);
  Eigen::Matrix3d R_WT;
  R_WT << out_W, closing_W, out_W.cross(closing_W);
  return inverse(X_WH) * Pose{p_W, Eigen::Quaterniond(R_WT)};
}

}  // namespace continua
