// continua check: is all that the project's files say of themselves still true?
#pragma once

#include <string>
#include <vector>

#include "replay/commands/command.h"

namespace continua {

struct CheckOptions {
  std::vector<std::string> paths;  ///< machines, lexicons, traces, or folders of them; empty: the knowledge folder
  std::string learned;             ///< file of what was taught, for traces; empty: none
  std::string knowledge;           ///< folder; empty: the program's own
  bool physics = true;
};

/// Runs the examples of machines and lexicons, and the expectations of traces; a line for each file on standard output,
/// what is not true on standard error. exit_done if all is true, exit_no if not, exit_impossible if a file cannot be
/// used.
int run_check(const CheckOptions& options);

void add_check_command(CLI::App& program, Run& run);

}  // namespace continua
