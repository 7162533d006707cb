// `continua diff`: where two runs, or two traces, part and why.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"

namespace continua {

struct DiffCommandOptions {
  std::string a, b;
  bool json = false, markdown = false;
  double tolerance_m = 1e-3;
  std::size_t most = 10;  ///< differences that are shown
};

int run_diff_command(const DiffCommandOptions& options);

void describe_diff(CLI::App& command, DiffCommandOptions& options);

}  // namespace continua
