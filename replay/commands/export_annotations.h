// The annotations that an export writes.
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/annotation/annotations.h"

namespace continua {

/// Whether the file begins like a trace.
bool is_trace_file(const std::string& path);

/// Annotations of a trace, or of a run with people's notes on it; linked to the recordings `media` besides those that
/// the trace names, whose paths are told as they start at the folder of `output`; "-": as the trace has them. If the
/// run's trace is beside it, the header of that is kept.
Result<Annotations> annotations_of_file(const std::string& path, const std::vector<std::string>& media,
                                        const std::string& output = "-");

}  // namespace continua
