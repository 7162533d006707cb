// continua table: the records of runs as tables.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/shard_option.h"

namespace continua {

struct TableOptions {
  std::vector<std::string> runs;  ///< run logs, and folders of them
  std::string output;             ///< a folder
  std::vector<std::string> kinds;
  ShardOptions shards;  ///< a shard writes into a folder of its own below `output`, which --merge reads
};

int run_table(const TableOptions& options);

void describe_table(CLI::App& command, TableOptions& options);

}  // namespace continua
