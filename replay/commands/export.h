// continua export: a run, a trace, or a replay of a trace, in another format; many runs as a site.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/graph_options.h"
#include "continua/replay/session/session.h"

namespace continua {

struct ExportOptions {
  std::vector<std::string> runs;  ///< one, except for a site
  std::string format;
  std::string output = "-";
  std::vector<std::string> media = {};  ///< recordings that annotations link
  std::vector<std::string> pairs = {};  ///< of a site: runs to be compared, the first with the second, and so on
  bool embed_media = false;             ///< into the page, which otherwise links them
  ReplayOptions replay = {};            ///< of a trace, where a run is exported
  GraphOptions picture = {};
  bool only_visited = false;  ///< svg and dot have what the run visited alone
};

int run_export(const ExportOptions& options);

void describe_export(CLI::App& command, ExportOptions& options);

}  // namespace continua
