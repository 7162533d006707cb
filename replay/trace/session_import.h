// Imports the session logs of VoxSim's studies: tab-separated rows of running index, channel, content and seconds.
// traces/FORMAT.md, "Import of VoxSim session logs", names the events that each channel becomes.
//
// A row that cannot be used is left out with a note; only a file without a single usable row is an error.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/result.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The machine that a trace of such a log names: the studies' avatar.
inline constexpr const char* imported_machine = "diana2018";

/// The log's events in its order and at its times; every event carries the `row` (line of the log) it comes from.
/// Notes are placed at the log's lines. `name` is the log's path; the header's `source` is its last part.
Result<Trace> import_session_text(std::string_view text, const std::string& name);
Result<Trace> import_session(const std::string& path);

/// Whether a file that begins like this is a session log: a first row of four columns with a known channel.
bool looks_like_session(std::string_view text);

}  // namespace continua
