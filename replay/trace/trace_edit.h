// Traces made of traces: cut, merged, shifted, selected. All functions keep the header unless they say so, and number
// the lines anew.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The events with from ≤ t < to, at their own times. Pieces that meet make the whole again: merge_traces().
Trace cut_trace(const Trace& trace, SimTime from, std::optional<SimTime> to);

/// The events of all, in order of time; of one time in the order of the traces. The header is the first one's. Of
/// several `end`s the last one stays. Error: one names another scene, machine, language, perspective or seed than the
/// first, or the same parameter with another value.
Result<Trace> merge_traces(const std::vector<Trace>& traces);

/// All times later by `by`, or earlier. Error: an event would come before the beginning, or after the end of time.
Result<Trace> shift_trace(const Trace& trace, SimTime by);

/// The events that are `wanted`, as their JSON.
Trace select_events(const Trace& trace, const std::function<bool(const Json& event)>& wanted);

/// The trace with each event changed by `change`, and its header's line by `change_header` where there is one. Error: a
/// changed line is none of a trace.
Result<Trace> changed_trace(const Trace& trace, const std::function<Json(Json event)>& change,
                            const std::function<Json(Json header)>& change_header = {});

}  // namespace continua
