// continua validate: checks files of any kind that the project has.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct ValidateOptions {
  std::vector<std::string> files;
};

/// "file: kind, size" on standard output for a valid file, else every problem as "file:line: sentence" on standard
/// error. exit_no if a file is not valid, exit_impossible if one cannot be read or is a machine that cannot be loaded.
int run_validate(const ValidateOptions& options);

void describe_validate(CLI::App& command, ValidateOptions& options);

}  // namespace continua
