// Why two runs part: of all that they do not have in common, the part that the first difference speaks for.
#pragma once

#include "continua/core/result.h"
#include "continua/replay/diff/run_diff.h"

namespace continua {

/// Fills in RunDiff::cause, `evidence` and `sentence`, from the rest of it. The error is of a record that cannot be
/// read.
Outcome find_cause(const RunIndex& a, const RunIndex& b, RunDiff& diff);

}  // namespace continua
