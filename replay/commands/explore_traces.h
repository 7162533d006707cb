// continua explore-traces: conversations that go wrong, looked for.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"
#include "continua/replay/session/session.h"

namespace continua {

struct ExploreTracesOptions {
  std::string output = ".";  ///< folder for the traces
  double time_s = 60;
  int runs = 0;  ///< so many instead; 0: as many as there is time for
  std::uint64_t seed = 0;
  bool guided = true;    ///< by coverage
  bool compare = true;   ///< the two worlds
  ReplayOptions replay;  ///< with scene and machine
};

/// exit_no if there are findings.
int run_explore_traces(const ExploreTracesOptions& options);

void describe_explore_traces(CLI::App& command, ExploreTracesOptions& options);

}  // namespace continua
