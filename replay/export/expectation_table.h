// The unmet expectations of a run as a table of a page.
#pragma once

#include <string>

#include "continua/replay/log/run_index.h"

namespace continua {

/// Field by field what was expected and what was found, in words, with the log's form as tooltips; HTML. Empty if all
/// expectations are met.
std::string unmet_table(const RunIndex& run);

}  // namespace continua
