// continua check: is all that the project's files say of themselves still true?
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "replay/commands/command.h"

namespace continua {

/// One part of several of about equal size, so that machines can share the work.
struct Shard {
  std::size_t index = 1, count = 1;  ///< index from 1
};

/// "2/4". Nothing if it is none.
std::optional<Shard> parse_shard(const std::string& text);

struct CheckOptions {
  std::vector<std::string> paths;  ///< machines, lexicons, traces, or folders of them; empty: the knowledge folder
  std::string knowledge;           ///< folder; empty: the program's own
  std::optional<bool> physics;     ///< false: the kinematic world; nullopt: that one if runs are to be approved
  int jobs = 1;
  Shard shard;
  std::string junit;  ///< a file; empty: none
  bool approve = false;
  bool yes = false;  ///< approve without asking
};

/// Runs the examples of machines and lexicons, and replays traces: their expectations, and the runs that are approved
/// (traces/FORMAT.md). A line for each file on standard output, what is not true on standard error. exit_done if all is
/// true, exit_no if not, exit_impossible if a file cannot be used or runs are to be approved and nobody can be asked.
int run_check(const CheckOptions& options);

void add_check_command(CLI::App& program, Run& run);

}  // namespace continua
