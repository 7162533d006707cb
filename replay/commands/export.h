// continua export: a run in another format.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"

namespace continua {

struct ExportOptions {
  std::string run, format;
  std::string output = "-";
};

int run_export(const ExportOptions& options);

void describe_export(CLI::App& command, ExportOptions& options);

}  // namespace continua
