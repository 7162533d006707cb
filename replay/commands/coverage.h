// continua coverage: the parts of their machines and of the knowledge that runs reach.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/shard_option.h"

namespace continua {

struct CoverageOptions {
  std::vector<std::string> paths;  ///< run logs, traces, or folders of them
  std::string knowledge;           ///< folder; empty: the program's own
  int jobs = 1;
  bool json = false;
  bool never = false;  ///< tell all that was never reached, not the first few
  int at_least = 0;    ///< per cent of a machine's own parts that must be reached; a shard alone is not asked
  ShardOptions shards;
};

/// Writes the coverage to standard output. Traces are replayed in the kinematic world, in memory. In a folder, a log
/// next to its trace is left out: the trace is replayed. exit_no below `at_least`, exit_impossible if a file cannot be
/// used; the others are told all the same.
int run_coverage(const CoverageOptions& options);

void describe_coverage(CLI::App& command, CoverageOptions& options);

}  // namespace continua
