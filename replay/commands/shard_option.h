// --shard I/N, --report FILE and --merge FILE…, the same in each command whose work can be shared.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/terminal/shard.h"

namespace CLI {
class App;
}

namespace continua {

struct ShardOptions {
  Shard shard;
  std::string report;              ///< a file for what came out, for --merge; empty: none
  std::vector<std::string> merge;  ///< reports to be told as one; empty: work
};

/// Adds --shard, which puts its value into `shard`.
void add_shard_option(CLI::App& command, Shard& shard);

/// Adds all three. `items` names the positional that --merge takes the place of, `doing` its work: "replaying".
void add_shard_options(CLI::App& command, ShardOptions& options, const std::string& items, const std::string& doing);

/// Called once the arguments are read: an error of the command line if there are neither items nor reports.
void expect_items(const std::vector<std::string>& items, const ShardOptions& options, const std::string& name);

/// Writes the report, if one is wanted. Gives its status, or exit_impossible if it cannot be written.
int keep_report(const ShardOptions& options, const ShardReport& made);

}  // namespace continua
