// continua shrink: the smallest trace that still does something.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/session/session.h"

namespace continua {

struct ShrinkCommandOptions {
  std::string trace;
  std::vector<std::string> until;  ///< the goals that it must still meet (replay/experiment/shrink_goal.h)
  std::string output;              ///< empty: NAME.shrunk.trace.jsonl in the current folder; "-": standard output
  std::string against;             ///< under `changed`; empty: the trace's approved run
  ReplayOptions replay;
};

/// exit_no, and a sentence on the trace's run, if the whole trace does not meet the goal.
int run_shrink(const ShrinkCommandOptions& options);

void describe_shrink(CLI::App& command, ShrinkCommandOptions& options);

}  // namespace continua
