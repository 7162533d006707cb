// A run in a few numbers: a line of the start page, and the beginning of the run's own page.
#pragma once

#include <cstddef>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// A line of the start page: {duration, records, utterances, acts, refusals, machine, scene, complete, first, …}.
/// `refused_samples` are the refusals of pointing samples, which come by the hundred while nobody waits for them;
/// `first` is the record of interest, at `first_t` (seconds); `drawable`: the log has the geometry for pictures.
Result<Json> run_listing(const RunIndex& run);

/// The record that a reader wants to see first: an expectation that was not met, else the place where the avatar first
/// had to ask, else the act that was asked for last, else the first utterance, refusal or decision.
std::size_t record_of_interest(const RunIndex& run);

/// The header without its long texts, the listing's numbers, and in `titles` the words for things, by their names.
Result<Json> run_summary(const RunIndex& run);

}  // namespace continua
