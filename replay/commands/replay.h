// continua replay: runs traces through the engine and writes their run logs.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/shard_option.h"
#include "continua/replay/session/session.h"

namespace continua {

struct ReplayCommandOptions {
  std::vector<std::string> traces;
  std::string output;  ///< a run log or a folder; empty: NAME.run.jsonl in the current folder; "-": standard output
  bool whole = false;  ///< logs in a folder have everything; otherwise documents are kept once beside them
  bool gzip = false;   ///< logs in a folder, or of no given name, are packed
  int jobs = 1;
  ShardOptions shards;
  ReplayOptions replay;
};

/// One line for each trace on standard output. exit_no if an expectation of a trace was not met.
int run_replay(const ReplayCommandOptions& options);

void describe_replay(CLI::App& command, ReplayCommandOptions& options);

}  // namespace continua
