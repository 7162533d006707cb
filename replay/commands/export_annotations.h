// The annotations that an export writes.
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/annotation/annotations.h"
#include "continua/replay/annotation/run_tiers.h"

namespace continua {

/// Whether the file begins like a trace.
bool is_trace_file(const std::string& path);

/// Annotations of a trace, or of a run with people's notes on it; linked to the recordings `media` besides those that
/// the trace names, whose paths are told as they start at the folder of `output`; "-": as the trace has them. If the
/// run's trace is beside it, the header of that is kept.
Result<Annotations> annotations_of_file(const std::string& path, const std::vector<std::string>& media,
                                        const std::string& output = "-");

/// People's notes on a run. Errors: the file with them cannot be read.
Result<std::vector<NoteOnRun>> notes_on(const RunIndex& run);

/// The header of the run's trace: the trace's own, if that lies beside the run and has not changed, else as far as the
/// run tells it.
Result<std::string> trace_header_of(const RunIndex& run);

}  // namespace continua
