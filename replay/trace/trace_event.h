// One event of a trace from and to its JSON; the functions of trace_file.h are made of these.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The largest time, seconds: SimTime's microseconds hold it with room to add.
inline constexpr double trace_time_limit_s = 1e9;

/// A coordinate that a recogniser may report, metres. Real logs hold pointing samples 13 km away; they mean "not on
/// the table" and are kept.
inline constexpr double trace_coordinate_limit_m = 1e9;

/// The fields that `kind` has; empty for an unknown kind.
const std::vector<std::string>& fields_of_kind(const std::string& kind);

/// The kinds of events.
const std::vector<std::string>& event_kinds();

/// The event on line `line` of `name`. Errors are added to `problems`, mere oddities to `notes`; with a problem the
/// event is not to be used.
TraceEvent event_from_json(Json json, const std::string& name, std::size_t line, std::vector<Error>& problems,
                           std::vector<Note>& notes);

/// Appends the members of `read`, an object, whose names are neither known nor in `json`.
void put_unknown_fields(Json& json, const Json& read, const std::vector<std::string>& known);

/// The event's own fields in their fixed order, followed by those of `event.json` that its kind does not have.
Json json_of(const TraceEvent& event);

}  // namespace continua
