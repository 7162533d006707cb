// Fixations in samples of where hands point; the steps of the method that DEIXIS.md tells.
#pragma once

#include <vector>

#include "continua/perception/deixis.h"

namespace continua {

/// Samples of one place, as indices: the places of a hand without jumps away and back.
using Tracklet = std::vector<std::size_t>;

/// Whether the sample's place is in `area`, by x and y; a place that is not finite is not.
bool is_believable(const PointingSample& sample, const Box& area);

/// `samples` in order of time. Each believable one belongs to one tracklet; in order of their first samples.
std::vector<Tracklet> tracklets_of(const std::vector<PointingSample>& samples, const Box& area);

/// Where the tracklet stays: parts of it, in order of time.
std::vector<Tracklet> stays_of(const Tracklet& tracklet, const std::vector<PointingSample>& samples);

/// All fixations in `samples`, in order of time, then hand and place.
std::vector<Deixis> fixations_in(const std::vector<PointingSample>& samples, const Box& area);

}  // namespace continua
