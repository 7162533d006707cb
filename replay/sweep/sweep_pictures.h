// Pictures of a sweep, as SVG for light and dark pages.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/sweep/sweep_result.h"

namespace continua {

/// The figure for each two names that have several values: its mean over all other values and seeds, a cell for each
/// two values. Empty if fewer than two names have several. Of more than eight names the first eight are shown.
std::string heat_maps(const std::vector<SweptPoint>& points, const std::string& figure);

/// A curve for each name that has several values: the figure's mean and its interval (SweepMean). Empty without such a
/// name.
std::string curves(const std::vector<SweptPoint>& points, const std::string& figure);

}  // namespace continua
