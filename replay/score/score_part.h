// A trace's score as text, for a shard's report, and read again: tables of what was read are those of the score.
#pragma once

#include <optional>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/score/score_report.h"

namespace continua {

/// JSON, on one line. `trace`: nothing if it could not be used.
std::string text_of_part(const std::string& variant, const std::optional<TraceScore>& trace);

/// Adds the line's trace, and takes over its variant. Error: it is no such line.
Outcome add_part(ScoreReport& report, const std::string& text);

}  // namespace continua
