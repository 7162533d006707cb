// The program's version, for `--version` and a run's fingerprint.
#pragma once

#include <string>

#include "continua/replay/log/records_of_log.h"

namespace continua {

/// The program's version and those of the libraries a run depends on, one a line, without a newline at the end.
std::string version_text();

/// The program's own version.
std::string program_version();

/// The things that physics may depend on: a run's poses are comparable byte for byte only under the same fingerprint
/// (RUNLOG.md).
log::Fingerprint fingerprint();

}  // namespace continua
