// continua sweep: the same traces under many settings of their machine.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/shard_option.h"
#include "continua/replay/session/session.h"

namespace continua {

struct SweepOptions {
  std::string grid;  ///< a file of points (sweep_grid.h)
  std::vector<std::string> traces;
  std::string output;  ///< a folder
  std::string figure;  ///< in pictures; empty: the first that there is
  int jobs = 1;
  ShardOptions shards;
  ReplayOptions replay;  ///< of all points
};

/// Replays what is not yet in the folder, and writes a table of all points to standard output; unless it is a shard,
/// the folder gets points.jsonl, points.csv, pictures and a page. exit_impossible if a trace cannot be replayed at a
/// point; that point is left out.
int run_sweep(const SweepOptions& options);

void describe_sweep(CLI::App& command, SweepOptions& options);

}  // namespace continua
