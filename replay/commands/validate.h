// continua validate: says of any of the project's files what is wrong with it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "replay/commands/command.h"

namespace continua {

struct FileCheck {
  std::vector<Error> problems;     ///< the file is not valid
  std::vector<std::string> notes;  ///< "file:line: sentence"; worth knowing, but valid
  std::string summary;             ///< "trace, 12 events"
  int status = exit_no;            ///< where there are problems
};

/// What a file of unknown kind is, and what is wrong with it. `path` is its name in messages.
FileCheck check_file(std::string_view text, const std::string& path);

struct ValidateOptions {
  std::vector<std::string> files;
};

/// "file: kind, size" on standard output for a valid file, else every problem as "file:line: sentence" on standard
/// error. exit_no if a file is not valid, exit_impossible if one cannot be read or is a machine that cannot be loaded.
int run_validate(const ValidateOptions& options);

void add_validate_command(CLI::App& program, Run& run);

}  // namespace continua
