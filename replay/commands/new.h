// continua new: a folder to begin a project in.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"

namespace continua {

struct NewOptions {
  std::string folder;
  std::string scene;           ///< a name or a path; empty: that of knowledge/live.json
  bool own_knowledge = false;  ///< a copy of machines, lexicon, phrases and voxemes too, to change
};

/// Fills a folder that is not there yet from knowledge/project, approves the runs of its traces, and checks them. What
/// was written stays when a check fails.
int run_new(const NewOptions& options);

void describe_new(CLI::App& command, NewOptions& options);

}  // namespace continua
