// The results of a check, as Markdown: for GitHub's page of a workflow's run, or a pull request.
#pragma once

#include <string>

#include "continua/replay/check/check_report.h"

namespace continua {

/// A heading with the total, a table of the verdicts with their numbers, and the failures, each with its details
/// folded.
std::string markdown_of(const CheckReport& report);

}  // namespace continua
