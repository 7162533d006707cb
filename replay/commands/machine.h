// continua machine: a machine in numbers, and its picture.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/graph_options.h"

namespace continua {

struct MachineOptions {
  std::string machine;    ///< a name or a path
  std::string knowledge;  ///< folder; empty: the program's own
  bool dot = false, svg = false;
  std::string output = "-";
  bool jff = false;
  bool jsgf = false;            ///< the grammar of sentences, for recognisers of speech
  std::string scene = {};       ///< whose words the grammar has; empty: that of live sessions
  std::string dictionary = {};  ///< a recogniser's pronouncing dictionary; empty: the grammar has all words
  std::size_t patterns = 100;   ///< the most sentence patterns of the grammar
  GraphOptions picture = {};
  std::string visited = {};  ///< a run, whose visits a picture shows alone
};

/// A description on standard output, or a picture to `output`.
int run_machine(const MachineOptions& options);

void describe_machine(CLI::App& command, MachineOptions& options);

}  // namespace continua
