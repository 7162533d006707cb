// The inspector's answers about a run, for a page that has no server.
#pragma once

#include <functional>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// A line for each answer of `api` (inspector_api.h) about the run of this id: the question in short, a tab, the answer
/// as JSON; web/run/recorded.js reads them. Views for which the log has nothing are left out, and why something is so
/// is told of the records worth stopping at (run_stops.h). `progress` is called with the part that is done. Errors: the
/// log cannot be read, or is too long for a file (most_page_log).
Result<std::string> run_answers(InspectorApi& api, const std::string& id, const RunIndex& run,
                                const std::function<void(double done)>& progress = {});

/// One line of them.
std::string answer_line(const std::string& question, const std::string& json);

}  // namespace continua
