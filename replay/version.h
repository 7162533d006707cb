// What `--version` and a run's fingerprint say about the program.
#pragma once

#include <string>

namespace continua {

/// The program's version and those of the libraries a run depends on, one a line, without a newline at the end.
std::string version_text();

}  // namespace continua
