// Every kind of file that the project has: how to tell it by, and how to check it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/terminal/terminal.h"

namespace continua {

struct FileCheck {
  std::vector<Error> problems;     ///< the file is not valid
  std::vector<std::string> notes;  ///< "file:line: sentence"; worth knowing, but valid
  std::string summary;             ///< "trace, 12 events"
  int status = exit_no;            ///< where there are problems
};

/// The kind of a file and its problems. `path` is its name in messages.
FileCheck check_file(std::string_view text, const std::string& path);

}  // namespace continua
