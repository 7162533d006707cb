// Places and poses as a run log writes them, in frame W, metres. Nothing where a log has something else there.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "continua/core/located_json.h"
#include "continua/core/sim_time.h"

namespace continua {

using Point = std::array<double, 3>;
/// x, y, z, qw, qx, qy, qz; the quaternion has length 1.
using PoseNumbers = std::array<double, 7>;

/// Of [x, y] or [x, y, z]; without z at the table's surface.
std::optional<Point> point_in(const Json& list);

std::optional<PoseNumbers> pose_in(const Json& list);

/// Where an event points, and from where, if it has a ray.
struct PointedAt {
  Point target{};
  std::optional<Point> origin = {};
};

/// The target of an event, or where its ray meets the table's plane; nothing if it points nowhere.
std::optional<PointedAt> pointed_at(const Json& event);

/// Of a number of seconds that is a time; else `otherwise`.
SimTime time_in(const Json& seconds, SimTime otherwise);

}  // namespace continua
