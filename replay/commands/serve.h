// continua serve: the inspector.
#pragma once

#include <string>
#include <vector>

#include "replay/commands/command.h"

namespace continua {

struct ServeOptions {
  std::vector<std::string> paths;
  std::string address = "127.0.0.1";
  int port = 8080;
};

/// Prints the page's address and answers until it is interrupted.
int run_serve(const ServeOptions& options);

void add_serve_command(CLI::App& program, Run& run);

}  // namespace continua
