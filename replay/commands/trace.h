// continua trace: traces made of traces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct TraceCommandOptions {
  std::string what;  ///< "cut", "merge", "shift", "select", "rename", "anonymise" or "peaks"
  std::vector<std::string> traces;
  std::string output = "-";
  double from_s = 0;
  std::optional<double> to_s;
  double by_s = 0;
  std::vector<std::string> wanted;  ///< kinds of events, or texts
  bool others = false;              ///< the events that are not wanted, in their place
  std::vector<std::string> names;   ///< OLD=NEW
  std::string table;                ///< a JSON file of names
};

int run_trace(const TraceCommandOptions& options);

void describe_trace(CLI::App& command, TraceCommandOptions& options);

}  // namespace continua
