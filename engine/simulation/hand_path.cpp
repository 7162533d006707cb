#include "continua/simulation/hand_path.h"

#include <algorithm>
#include <cmath>

namespace continua {

namespace {

// Peaks of the minimum-jerk profile 10u³ - 15u⁴ + 6u⁵ over u in [0, 1]: of its first and second derivative.
constexpr double peak_speed = 1.875;
constexpr double peak_acceleration = 5.7735;

constexpr double knot_distance_m = 0.01;
constexpr double turn_as_m_per_rad = 0.06;  // a turn on the spot has a length too
constexpr double corner_radius_m = 0.025;   // a hand that comes down beside a stack must not cut the corner into it

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

/// Knots from posture to posture by the hinges alone, without both ends.
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
  const auto goal = find_ik(arm, X_WT.back());
  if (!first || !goal) return std::nullopt;
  // From the goal backward: the last line, and as many more as possible.
  std::optional<HandPath> last;
  std::vector<Pose> backward;
  for (std::size_t i = X_WT.size() - 1; i > 1 || (i == 1 && !last); --i) {
    backward.push_back(X_WT[i - 1]);
    auto longer = plan_straight(arm, *goal, backward, pace);
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
  return along(arm, std::move(knots), pace);
}

std::optional<HandPath> HandPath::plan_straight(const Arm& arm, const ArmVector& from, const std::vector<Pose>& X_WT,
                                                const Pace& pace) {
  std::vector<Pose> corners{tool_pose(arm, from)};
  corners.insert(corners.end(), X_WT.begin(), X_WT.end());
  const auto poses = rounded(corners);

  constexpr double farthest_turn =
      0.6;  // radians of a hinge from knot to knot; a larger turn is another branch of the arm
  std::vector<ArmVector> knots{from};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const IkSolution solution = solve_ik(arm, poses[i], knots.back());
    if (!solution.reached || (solution.q - knots.back()).cwiseAbs().maxCoeff() > farthest_turn) return std::nullopt;
    knots.push_back(solution.q);
  }
  return along(arm, std::move(knots), pace);
}

/// Each step lasts as long as its limits require, with neighbours about equally long; the whole has a minimum-jerk
/// profile.
HandPath HandPath::along(const Arm& arm, std::vector<ArmVector> knots, const Pace& pace) {
  constexpr double steady = 0.7;  // least part of a step's time that its neighbours last
  constexpr double least_s = 1e-3;
  constexpr int rounds = 40;
  if (knots.size() < 2) return stay(knots.front());
  std::vector<double> steps;
  Pose before = tool_pose(arm, knots.front());
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Pose after = tool_pose(arm, knots[i]);
    steps.push_back(std::max({length(before, after) / pace.hand_m_per_s,
                              (knots[i] - knots[i - 1]).cwiseAbs().maxCoeff() / pace.hinge_rad_per_s, least_s}));
    before = after;
  }
  const auto bend = [&](std::size_t i) {  // change of speed at the knot between steps i - 1 and i
    const ArmVector jump = (knots[i + 1] - knots[i]) / steps[i] - (knots[i] - knots[i - 1]) / steps[i - 1];
    return jump.cwiseAbs().maxCoeff() * 2 / (steps[i] + steps[i - 1]);
  };
  double most_bend = 0;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 1; i < steps.size(); ++i) steps[i] = std::max(steps[i], steady * steps[i - 1]);
    for (std::size_t i = steps.size() - 1; i > 0; --i) steps[i - 1] = std::max(steps[i - 1], steady * steps[i]);
    most_bend = 0;
    auto slower = steps;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      const double by = bend(i) / pace.hinge_rad_per_s2;
      most_bend = std::max(most_bend, bend(i));
      if (by <= 1) continue;
      slower[i - 1] = std::max(slower[i - 1], steps[i - 1] * std::min(2.0, std::sqrt(by)));
      slower[i] = std::max(slower[i], steps[i] * std::min(2.0, std::sqrt(by)));
    }
    if (most_bend <= pace.hinge_rad_per_s2) break;
    steps = std::move(slower);
  }

  HandPath path;
  path.knots_ = std::move(knots);
  path.at_s_ = {0};
  double fastest = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    path.at_s_.push_back(path.at_s_.back() + steps[i]);
    fastest = std::max(fastest, (path.knots_[i + 1] - path.knots_[i]).cwiseAbs().maxCoeff() / steps[i]);
  }
  const double whole_s = path.at_s_.back();
  const double by_speed = peak_speed * whole_s;
  const double by_acceleration =
      std::sqrt((peak_acceleration * whole_s * fastest + by_speed * by_speed * most_bend) / pace.hinge_rad_per_s2);
  path.duration_s_ = std::max(by_speed, by_acceleration);
  return path;
}

HandPath HandPath::between(const ArmVector& from, const ArmVector& to, const Pace& pace) {
  HandPath path;
  path.knots_ = {from, to};
  path.at_s_ = {0, 1};
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

  // Catmull-Rom between the knots, so that the hinges' speed does not jump.
  const double s = along * at_s_.back();
  const auto next = std::upper_bound(at_s_.begin() + 1, at_s_.end() - 1, s);
  const auto i = static_cast<std::size_t>(next - at_s_.begin()) - 1;
  const double step = at_s_[i + 1] - at_s_[i], u_i = (s - at_s_[i]) / step;
  const ArmVector &p1 = knots_[i], &p2 = knots_[i + 1];
  const auto slope = [&](std::size_t from, std::size_t to) -> ArmVector {
    return (knots_[to] - knots_[from]) * (step / (at_s_[to] - at_s_[from]));
  };
  const ArmVector m1 = slope(i > 0 ? i - 1 : i, i + 1), m2 = slope(i, i + 2 < knots_.size() ? i + 2 : i + 1);
  const ArmVector a = 2 * (p1 - p2) + m1 + m2, b = 3 * (p2 - p1) - 2 * m1 - m2;
  return {p1 + u_i * (m1 + u_i * (b + u_i * a)), (m1 + u_i * (2 * b + 3 * u_i * a)) * (at_s_.back() * rate / step)};
}

}  // namespace continua
