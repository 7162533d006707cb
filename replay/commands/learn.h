// continua learn: estimates a machine's weights from traces with the observed answers of another avatar.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/session/session.h"

namespace continua {

struct LearnOptions {
  std::string machine;  ///< a name or a path
  std::vector<std::string> traces;
  std::string output;     ///< the file of weights
  double held_out = 0.5;  ///< share of the traces that is not learned from, 0 … 0.9
  int jobs = 1;
  ReplayOptions replay;
};

/// Writes the weights, and how well they fit the traces held out to standard output. exit_impossible if a trace cannot
/// be used.
int run_learn(const LearnOptions& options);

void describe_learn(CLI::App& command, LearnOptions& options);

}  // namespace continua
