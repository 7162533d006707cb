// continua coverage: what of their machines and of the knowledge do these runs reach?
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct CoverageOptions {
  std::vector<std::string> paths;  ///< run logs, traces, or folders of them
  std::string knowledge;           ///< folder; empty: the program's own
  int jobs = 1;
  bool json = false;
  bool never = false;  ///< tell all that was never reached, not the first few
  int at_least = 0;    ///< per cent that must be reached of what is a machine's own
};

/// Writes what was reached to standard output. Traces are replayed in the kinematic world, in memory. Of a folder, the
/// logs that go with a trace beside them are left out: it is replayed. exit_no below `at_least`, exit_impossible if a
/// file cannot be used; the others are told all the same.
int run_coverage(const CoverageOptions& options);

void describe_coverage(CLI::App& command, CoverageOptions& options);

}  // namespace continua
