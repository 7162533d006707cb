// A client's events for a live session: in the form of the trace, checked before any of them counts.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The source of time in a live session.
enum class LiveTiming {
  wall,    ///< the wall's clock
  events,  ///< the times that events tell, for sources that have a clock of their own
};

/// The events of a request's body: one object, an array of them, also as {"events": […]}, or JSON Lines. The error
/// names the line.
Result<std::vector<Json>> events_in(std::string_view body);

/// Whether the event tells its own time.
bool has_time(const Json& event);

/// An event as it counts.
struct LiveEvent {
  SimTime t;                        ///< of the engine, when it takes it
  std::optional<TraceEvent> event;  ///< none: only time goes on
  std::string line;                 ///< of the trace, without its newline; empty without an event
};

/// Gives each event its place in time (traces/FORMAT.md, `happened`): `now` is the engine's time, `next_line` that of
/// the trace. None is earlier than the one before it. Errors: the first that cannot be used, and why.
Result<std::vector<LiveEvent>> timed_events(const std::vector<Json>& events, LiveTiming timing, SimTime now,
                                            std::size_t next_line);

}  // namespace continua
