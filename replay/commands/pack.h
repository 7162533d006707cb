// continua pack: keeps what run logs have in common once beside them, or puts it back, and packs them with gzip.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct PackOptions {
  std::vector<std::string> paths;  ///< run logs, folders of them, traces
  bool whole = false;              ///< put it back
  std::optional<bool> gzip;        ///< whether they are packed afterwards; otherwise as they are
};

/// One line for each path on standard output.
int run_pack(const PackOptions& options);

void describe_pack(CLI::App& command, PackOptions& options);

}  // namespace continua
