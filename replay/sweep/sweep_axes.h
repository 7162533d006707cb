// The values of a sweep's points as axes with a few levels, and means over them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/replay/sweep/sweep_result.h"

namespace continua {

/// A name that has several values. Numbers go upwards; more than `most_levels` different ones are put into equal parts
/// of their range, named by their middles. Other values come in the order of the points.
struct SweepAxis {
  std::string name;
  std::vector<std::string> levels;
  std::vector<std::optional<std::size_t>> level_of;  ///< of each point; nothing: the point has no such value
};

inline constexpr std::size_t most_levels = 12;

std::vector<SweepAxis> axes_of(const std::vector<SweptPoint>& points);

/// A figure at a level of an axis, or at several of several.
struct SweepMean {
  std::size_t points = 0;  ///< 0: there is none
  double mean = 0;
  /// With several seeds, the 95 % interval of the mean over seeds (Student's t); otherwise lowest and highest value.
  double low = 0, high = 0;
};

/// The figures of the points for which `level` is the axis' level, and of those at both levels of two axes.
SweepMean mean_at(const std::vector<SweptPoint>& points, const std::string& figure, const SweepAxis& axis,
                  std::size_t level);
SweepMean mean_at(const std::vector<SweptPoint>& points, const std::string& figure, const SweepAxis& across,
                  std::size_t column, const SweepAxis& down, std::size_t row);

/// Whether the points have several seeds.
bool has_seeds(const std::vector<SweptPoint>& points);

}  // namespace continua
