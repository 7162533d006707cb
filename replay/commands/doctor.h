// continua doctor: whether the program and all that it uses work on this machine.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"

namespace continua {

struct DoctorOptions {
  std::string knowledge;  ///< folder; empty: the program's own
  int port = 8080;        ///< that the page would have
};

/// Prints a line for each part. Without a replay or a page the answer is no.
int run_doctor(const DoctorOptions& options);

void describe_doctor(CLI::App& command, DoctorOptions& options);

}  // namespace continua
