// continua check: is all that the project's files say of themselves still true?
#pragma once

#include "continua/replay/check/run_check.h"
#include "continua/replay/commands/command.h"

namespace continua {

void describe_check(CLI::App& command, CheckOptions& options);

}  // namespace continua
