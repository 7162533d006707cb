// The run of a trace, for a command that works on runs.
#pragma once

#include <filesystem>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/session/session.h"

namespace continua {

/// Replays the trace into a run log in `folder`, with progress on a terminal, and returns its path. Errors: the trace
/// cannot be replayed to its end; the log cannot be written.
Result<std::string> replayed_run(const std::string& trace, ReplayOptions options, const std::filesystem::path& folder);

}  // namespace continua
