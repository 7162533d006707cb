// The coverage of a run as text, for a shard's report, and read again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/replay/coverage/coverage.h"

namespace continua {

/// JSON, on one line. Nothing: the file could not be used.
std::string text_of_part(const std::optional<MachineCoverage>& run);

/// Adds the line's coverage, if it has one. Error: it is no such line.
Outcome add_part(std::vector<MachineCoverage>& runs, const std::string& text);

}  // namespace continua
