// One point of a sweep: the traces' replays, and the line of their figures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/replay/session/session.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/sweep/sweep_grid.h"

namespace continua {

/// The things that all points have in common.
struct SweepGiven {
  std::vector<std::string> traces;
  ReplayOptions options;
  std::string with;    ///< the options as a command line of `continua replay` has them
  std::string digest;  ///< of traces, knowledge, scenes, options and program: points of another digest are done again
};

/// Loads each trace once. Errors: one of them cannot be replayed.
Result<SweepGiven> sweep_given(const std::vector<std::string>& traces, const ReplayOptions& options);

/// Replays the traces: the point's line without its number (sweep_result.h).
Result<Json> swept(const SweepGiven& given, const SweepPoint& point);

}  // namespace continua
