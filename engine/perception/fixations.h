// Finds fixations in pointing samples: the steps of the method in DEIXIS.md.
#pragma once

#include <vector>

#include "continua/perception/deixis.h"

namespace continua {

/// Indices of samples of one place: a hand without its jumps away and back.
using Tracklet = std::vector<std::size_t>;

/// Whether the sample's place is in `area`, by x and y. A place that is not finite is outside.
bool is_believable(const PointingSample& sample, const Box& area);

/// The tracklets of `samples`, which are in order of time. Each believable sample belongs to one tracklet. Tracklets
/// are in the order of their first samples.
std::vector<Tracklet> tracklets_of(const std::vector<PointingSample>& samples, const Box& area);

/// The parts of a tracklet in which it stays at one place, in order of time.
std::vector<Tracklet> stays_of(const Tracklet& tracklet, const std::vector<PointingSample>& samples);

/// All fixations in `samples`, in order of time, then hand and place.
std::vector<Deixis> fixations_in(const std::vector<PointingSample>& samples, const Box& area);

}  // namespace continua
