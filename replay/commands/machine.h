// continua machine: a machine in numbers, and its picture.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"

namespace continua {

struct MachineOptions {
  std::string machine;    ///< a name or a path
  std::string knowledge;  ///< folder; empty: the program's own
  bool dot = false, svg = false;
  std::string output = "-";
  bool jff = false;
};

/// A description on standard output, or a picture to `output`.
int run_machine(const MachineOptions& options);

void describe_machine(CLI::App& command, MachineOptions& options);

}  // namespace continua
