// Numbers of a log on a grid, so that the last bits of floating point do not reach its lines.
#pragma once

#include <cmath>

namespace continua {

inline constexpr double pose_steps_per_metre = 1e5;
inline constexpr double quaternion_steps = 1e6;
inline constexpr double steps_per_radian = 1e3;

/// The nearest multiple of 1 / `steps_per_unit`; never -0.
inline double rounded(double value, double steps_per_unit) {
  return std::round(value * steps_per_unit) / steps_per_unit + 0.0;
}

}  // namespace continua
