// The trace of a live session, read while it is being written or afterwards.
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/live/live_events.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The trace at `path` as far as its lines are whole.
Result<Trace> read_so_far(const std::string& path);

/// Scene, machine and recordings that the header names by their ways from the trace at `path` are named as from
/// `folder`.
void move_header(TraceHeader& header, const std::string& path, const std::string& folder);

/// An ended session, for one that goes on with it.
struct SessionBefore {
  TraceHeader header;
  std::vector<LiveEvent> events;  ///< the last lets time go on to where it ended
};

/// The session whose trace is at `path`, to go on in `folder`. Errors: the trace cannot be read, or is not whole.
Result<SessionBefore> read_before(const std::string& path, const std::string& folder);

}  // namespace continua
