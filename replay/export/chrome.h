// A run as Chrome trace events, for viewers of time lines that read them: Perfetto, chrome://tracing, speedscope.
#pragma once

#include <iosfwd>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Writes {"traceEvents": [{"ph", "ts", "pid", "tid", "name", …}, …]}, times in microseconds of the run's clock. A lane
/// (thread) for the human's events, for the states of the machine, from one transition to another state to the next,
/// for its transitions, for the avatar's words and gestures, and for acts with their steps in them. All are complete
/// slices (X) that nest or follow one another; something without length is shown until the next, a second at most,
/// transitions for 40 ms. Arrows (s, f) lead from causes to their consequences; the number of stack symbols is a
/// counter (C). `args` has the record's number and members. Samples of pointing, poses and the log's own records are
/// left out. An act whose end is not in the log goes on to its last record. Source of the format: Google, Trace Event
/// Format.
Outcome export_chrome(const RunIndex& run, std::ostream& out);

}  // namespace continua
