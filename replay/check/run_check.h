// The whole of `continua check`: the files, their reports, and the approval of runs.
#pragma once

#include "continua/replay/check/checking.h"

namespace continua {

/// Runs the examples of machines and lexicons, and replays traces: their expectations, and their approved runs
/// (traces/FORMAT.md). Prints a line for each file on standard output, faults on standard error, a total, and the
/// requested reports. Or, given reports of shards, the same without checking. exit_done if all holds, exit_no if not,
/// exit_impossible if a file cannot be used, a shard is missing, or runs are to be approved and nobody can be asked.
int run_check(const CheckOptions& options);

}  // namespace continua
