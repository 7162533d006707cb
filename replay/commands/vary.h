// continua vary: traces as noisier recognisers would have told them.
#pragma once

#include <cstdint>
#include <string>

#include "continua/replay/commands/command.h"

namespace continua {

struct VaryOptions {
  std::string trace, noise = "standard", output;  ///< `output`: a folder
  std::string knowledge;                          ///< folder; empty: the program's own
  int count = 1;
  std::uint64_t seed = 0;  ///< of the first; each further one has the next
  bool changes = false;    ///< each is told
};

int run_vary(const VaryOptions& options);

void describe_vary(CLI::App& command, VaryOptions& options);

}  // namespace continua
