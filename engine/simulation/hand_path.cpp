#include "simulation/hand_path.h"

#include <algorithm>
#include <cmath>

namespace continua {

namespace {

// Peaks of the minimum-jerk profile 10u³ - 15u⁴ + 6u⁵ over u in [0, 1]: of its first and second derivative.
constexpr double peak_speed = 1.875;
constexpr double peak_acceleration = 5.7735;

constexpr double knot_distance_m = 0.01;
constexpr double turn_as_m_per_rad = 0.06;  // so that turning on the spot has a length too
constexpr double corner_radius_m = 0.025;   // what comes down beside a stack must not yet be lower than its top before

double length(const Pose& a, const Pose& b) {
  return (b.p_WB - a.p_WB).norm() + turn_as_m_per_rad * a.R_WB.angularDistance(b.R_WB);
}

/// Appends poses at equal steps along the straight line from the last of `poses`.
void add_line(const Pose& b, std::vector<Pose>& poses) {
  const Pose a = poses.back();
  const int steps = std::max(1, static_cast<int>(std::ceil(length(a, b) / knot_distance_m)));
  for (int i = 1; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    poses.push_back({a.p_WB + s * (b.p_WB - a.p_WB), a.R_WB.slerp(s, b.R_WB)});
  }
}

Pose between(const Pose& a, const Pose& b, double distance) {
  const double s = std::min(1.0, distance / std::max(length(a, b), 1e-9));
  return {a.p_WB + s * (b.p_WB - a.p_WB), a.R_WB.slerp(s, b.R_WB)};
}

/// The polygon with each corner replaced by a parabola that begins and ends at most `corner_radius_m` from it.
std::vector<Pose> rounded(const std::vector<Pose>& corners) {
  std::vector<Pose> poses{corners.front()};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double before = length(corners[i - 1], corners[i]), after = length(corners[i], corners[i + 1]);
    const double cut = std::min({corner_radius_m, before / 2, after / 2});
    const Pose in = between(corners[i], corners[i - 1], cut), out = between(corners[i], corners[i + 1], cut);
    if (length(poses.back(), in) > 1e-9) add_line(in, poses);
    const int steps = std::max(2, static_cast<int>(std::ceil(2 * cut / knot_distance_m)));
    for (int k = 1; k <= steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      const Pose a = between(in, corners[i], s * length(in, corners[i]));
      const Pose b = between(corners[i], out, s * length(corners[i], out));
      poses.push_back({a.p_WB + s * (b.p_WB - a.p_WB), a.R_WB.slerp(s, b.R_WB)});
    }
  }
  if (length(poses.back(), corners.back()) > 1e-9) add_line(corners.back(), poses);
  return poses;
}

/// From posture to posture by the hinges alone, both ends left out.
std::vector<ArmVector> by_hinges(const ArmVector& from, const ArmVector& to) {
  constexpr double knot_turn = 0.04;  // radians
  std::vector<ArmVector> knots;
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).cwiseAbs().maxCoeff() / knot_turn)));
  for (int i = 1; i < steps; ++i) knots.push_back(from + (to - from) * i / steps);
  return knots;
}

double deepest(const std::vector<ArmVector>& knots, const HandPath::Depth& depth) {
  double most = 0;
  for (const auto& q : knots) most = std::max(most, depth(q));
  return most;
}

}  // namespace

std::optional<HandPath> HandPath::plan(const Arm& arm, const ArmVector& from, const std::vector<Pose>& X_WT,
                                       const Pace& pace, const Depth& depth) {
  const auto straight = plan_straight(arm, from, X_WT, pace);
  if (straight || X_WT.size() < 2) return straight;
  const auto first = plan_straight(arm, from, {X_WT.front()}, pace);
  const IkSolution goal = find_ik(arm, X_WT.back());
  if (!first || !goal.reached) return std::nullopt;
  // The last line backward, and more of them if that can be done.
  std::optional<HandPath> last;
  std::vector<Pose> backward;
  for (std::size_t i = X_WT.size() - 1; i > 1 || (i == 1 && !last); --i) {
    backward.push_back(X_WT[i - 1]);
    auto longer = plan_straight(arm, goal.q, backward, pace);
    if (!longer) break;
    last = std::move(longer);
  }
  if (!last) return std::nullopt;

  const ArmVector start = first->end(), end = last->end();
  auto between = by_hinges(start, end);
  if (depth && deepest(between, depth) > 0) {
    auto by_home = by_hinges(start, arm.home);
    by_home.push_back(arm.home);
    for (const auto& q : by_hinges(arm.home, end)) by_home.push_back(q);
    if (deepest(by_home, depth) < deepest(between, depth)) between = std::move(by_home);
  }
  std::vector<ArmVector> knots = first->knots_;
  knots.insert(knots.end(), between.begin(), between.end());
  knots.insert(knots.end(), last->knots_.rbegin(), last->knots_.rend());
  const double path_m = static_cast<double>(knots.size()) * knot_distance_m;
  return along(std::move(knots), path_m, pace);
}

std::optional<HandPath> HandPath::plan_straight(const Arm& arm, const ArmVector& from, const std::vector<Pose>& X_WT,
                                                const Pace& pace) {
  std::vector<Pose> corners{tool_pose(arm, from)};
  corners.insert(corners.end(), X_WT.begin(), X_WT.end());
  const auto poses = rounded(corners);

  std::vector<ArmVector> knots{from};
  double path_m = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const IkSolution solution = solve_ik(arm, poses[i], knots.back());
    if (!solution.reached) return std::nullopt;
    path_m += length(poses[i - 1], poses[i]);
    knots.push_back(solution.q);
  }
  return along(std::move(knots), path_m, pace);
}

/// As fast as the slowest limit allows.
HandPath HandPath::along(std::vector<ArmVector> knots, double path_m, const Pace& pace) {
  HandPath path;
  path.knots_ = std::move(knots);
  // Per step along the path: how far each hinge turns, and how that changes.
  const double steps = static_cast<double>(path.knots_.size() - 1);
  double first = 0, second = 0;
  for (std::size_t i = 1; i < path.knots_.size(); ++i) {
    first = std::max(first, (path.knots_[i] - path.knots_[i - 1]).cwiseAbs().maxCoeff());
    if (i + 1 < path.knots_.size())
      second = std::max(second, (path.knots_[i + 1] - 2 * path.knots_[i] + path.knots_[i - 1]).cwiseAbs().maxCoeff());
  }
  const double by_hand = peak_speed * path_m / pace.hand_m_per_s;
  const double by_speed = peak_speed * first * steps / pace.hinge_rad_per_s;
  const double by_acceleration = std::sqrt(
      (peak_acceleration * first * steps + peak_speed * peak_speed * second * steps * steps) / pace.hinge_rad_per_s2);
  path.duration_s_ = std::max({by_hand, by_speed, by_acceleration});
  return path;
}

HandPath HandPath::between(const ArmVector& from, const ArmVector& to, const Pace& pace) {
  HandPath path;
  path.knots_ = {from, to};
  const double turn = (to - from).cwiseAbs().maxCoeff();
  path.duration_s_ =
      std::max(peak_speed * turn / pace.hinge_rad_per_s, std::sqrt(peak_acceleration * turn / pace.hinge_rad_per_s2));
  return path;
}

HandPath HandPath::stay(const ArmVector& q) {
  HandPath path;
  path.knots_.push_back(q);
  return path;
}

HingeTarget HandPath::at(double t_s) const {
  if (t_s >= duration_s_ || knots_.size() < 2) return {knots_.back(), ArmVector::Zero(knots_.back().size())};
  const double u = std::max(0.0, t_s / duration_s_);
  const double along = u * u * u * (10 + u * (-15 + 6 * u));
  const double rate = 30 * u * u * (1 - u) * (1 - u) / duration_s_;

  // Catmull-Rom between the knots: the hinges' speed does not jump.
  const double steps = static_cast<double>(knots_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(along * steps), knots_.size() - 2);
  const double s = along * steps - static_cast<double>(i);
  const ArmVector &p1 = knots_[i], &p2 = knots_[i + 1];
  const ArmVector m1 = i > 0 ? ((p2 - knots_[i - 1]) / 2).eval() : (p2 - p1).eval();
  const ArmVector m2 = i + 2 < knots_.size() ? ((knots_[i + 2] - p1) / 2).eval() : (p2 - p1).eval();
  const ArmVector a = 2 * (p1 - p2) + m1 + m2, b = 3 * (p2 - p1) - 2 * m1 - m2;
  return {p1 + s * (m1 + s * (b + s * a)), (m1 + s * (2 * b + 3 * s * a)) * steps * rate};
}

}  // namespace continua
