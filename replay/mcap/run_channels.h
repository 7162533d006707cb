// A run as an MCAP file (MCAP.md).
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/annotation/run_tiers.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// The name of the metadata with the trace's header, in the entry "trace".
inline constexpr const char* mcap_metadata = "continua";

/// The schema of events of a trace.
inline constexpr const char* mcap_event_schema = "continua.Event";

/// Writes the run with people's notes on it; `trace_header` as a trace has it. Errors: a record cannot be read, or
/// nothing can be written.
Outcome export_mcap(const RunIndex& run, const std::vector<NoteOnRun>& notes, const std::string& trace_header,
                    std::ostream& out);

}  // namespace continua
