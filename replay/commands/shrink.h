// continua shrink: the smallest trace that still does something.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/session/session.h"

namespace continua {

struct ShrinkCommandOptions {
  std::string trace;
  std::vector<std::string> until;  ///< what it must still do (replay/experiment/shrink_goal.h)
  std::string output;              ///< empty: NAME.shrunk.trace.jsonl in the current folder; "-": standard output
  std::string against;             ///< under `changed`; empty: the approved run beside the trace
  ReplayOptions replay;
};

/// exit_no, and a sentence on what it does instead, if the whole trace does not do it.
int run_shrink(const ShrinkCommandOptions& options);

void describe_shrink(CLI::App& command, ShrinkCommandOptions& options);

}  // namespace continua
