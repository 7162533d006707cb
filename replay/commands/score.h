// continua score: how far do the avatar's moves agree with those that traces recorded?
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/shard_option.h"
#include "continua/replay/session/session.h"

namespace continua {

struct ScoreOptions {
  std::vector<std::string> traces;
  std::string output;  ///< folder that the run logs are written to, NAME.run.jsonl; empty: they are not kept
  bool whole = false;  ///< these have everything; otherwise documents are kept once beside them
  bool gzip = false;   ///< these are packed
  int jobs = 1;
  bool json = false, markdown = false;
  bool all_misses = false;  ///< tell all, not the first few of each trace
  ShardOptions shards;
  ReplayOptions replay;  ///< REQUIRES physics == false
};

/// Writes the score to standard output. exit_impossible if a trace cannot be used; the others are scored all the same.
int run_score(const ScoreOptions& options);

void describe_score(CLI::App& command, ScoreOptions& options);

}  // namespace continua
