// continua import: session logs of VoxSim, annotations of ELAN and Praat, MCAP files, and outputs of recognisers, to
// traces.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct ImportOptions {
  std::vector<std::string> logs;
  std::string output;                  ///< a trace, "-", or a folder; with several logs always a folder
  std::vector<std::string> from = {};  ///< formats of recognisers: the files make one trace
  std::string camera = {};             ///< the file of the recognisers' camera; empty: none
  std::string frame = "world";         ///< of the table in transforms of MCAP files
  std::string tiers = {};              ///< the map of tiers of annotations; empty: it is guessed, and printed
};

/// Notes go to standard error, one line in total to standard output (to standard error if the trace goes there).
/// Logs that cannot be imported are reported and passed over.
int run_import(const ImportOptions& options);

void describe_import(CLI::App& command, ImportOptions& options);

}  // namespace continua
