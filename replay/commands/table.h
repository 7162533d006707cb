// continua table: the records of runs as tables.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct TableOptions {
  std::vector<std::string> runs;  ///< run logs, and folders of them
  std::string output;             ///< a folder
  std::vector<std::string> kinds;
};

int run_table(const TableOptions& options);

void describe_table(CLI::App& command, TableOptions& options);

}  // namespace continua
