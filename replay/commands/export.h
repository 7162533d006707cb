// continua export: a run in another format.
#pragma once

#include <string>

#include "replay/commands/command.h"

namespace continua {

struct ExportOptions {
  std::string run, format;
  std::string output = "-";
};

int run_export(const ExportOptions& options);

void add_export_command(CLI::App& program, Run& run);

}  // namespace continua
