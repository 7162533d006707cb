#include "continua/replay/scene/run_points.h"

#include <cmath>

#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

constexpr double latest_s = 1e9;

template <std::size_t count>
bool read_numbers(const Json& list, std::array<double, count>& into) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_number()) return false;
    into[i] = list[i].get<double>();
  }
  return true;
}

}  // namespace

std::optional<Point> point_in(const Json& list) {
  Point point{};
  if (!list.is_array() || list.size() < 2 || list.size() > 3 || !read_numbers(list, point)) return std::nullopt;
  return point;
}

std::optional<PoseNumbers> pose_in(const Json& list) {
  PoseNumbers pose{};
  if (!list.is_array() || list.size() != pose.size() || !read_numbers(list, pose)) return std::nullopt;
  const double length = std::hypot(std::hypot(pose[3], pose[4]), std::hypot(pose[5], pose[6]));
  if (!(length > 0.5) || !std::isfinite(length)) return std::nullopt;
  // Logged components are rounded, so the length may differ from 1 by as much.
  if (std::abs(length - 1) > 1e-3)
    for (std::size_t i = 3; i < pose.size(); ++i) pose[i] /= length;
  return pose;
}

std::optional<PointedAt> pointed_at(const Json& event) {
  if (const auto target = point_in(member_of(event, "target"))) return PointedAt{*target};
  const auto& ray = member_of(event, "ray");
  const auto from = point_in(member_of(ray, "from")), direction = point_in(member_of(ray, "direction"));
  if (!from || !direction || (*from)[2] * (*direction)[2] >= 0) return std::nullopt;
  const double steps = -(*from)[2] / (*direction)[2];
  Point target = *from;
  for (std::size_t i = 0; i < target.size(); ++i) target[i] += steps * (*direction)[i];
  return PointedAt{target, from};
}

SimTime time_in(const Json& seconds, SimTime otherwise) {
  if (!seconds.is_number()) return otherwise;
  const double s = seconds.get<double>();
  return std::abs(s) <= latest_s ? SimTime::from_seconds(s) : otherwise;
}

}  // namespace continua
