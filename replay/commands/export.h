// continua export: a run, or a trace, in another format.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct ExportOptions {
  std::string run, format;
  std::string output = "-";
  std::vector<std::string> media = {};  ///< recordings that annotations link
};

int run_export(const ExportOptions& options);

void describe_export(CLI::App& command, ExportOptions& options);

}  // namespace continua
