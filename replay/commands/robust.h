// continua robust: how much noise conversations bear.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/experiment/robust.h"

namespace continua {

struct RobustCommandOptions {
  std::vector<std::string> traces;
  std::string noise = "standard";
  std::vector<std::string> kinds;  ///< of noise; empty: all
  std::vector<double> strengths{0.25, 0.5, 1, 2};
  int count = 10, jobs = 1;
  std::uint64_t seed = 0;
  std::string output;  ///< a picture; empty: none
  std::string breaks;  ///< folder for traces that break a run; empty: none
  bool json = false;
  ReplayOptions replay;
};

/// exit_no if a run does something else.
int run_robust(const RobustCommandOptions& options);

void describe_robust(CLI::App& command, RobustCommandOptions& options);

}  // namespace continua
