// continua pack: keeps what run logs have in common once beside them, or puts it back.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct PackOptions {
  std::vector<std::string> paths;  ///< run logs, or folders of them
  bool whole = false;              ///< put it back
};

/// One line for each path on standard output.
int run_pack(const PackOptions& options);

void describe_pack(CLI::App& command, PackOptions& options);

}  // namespace continua
