// continua serve: the inspector.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct ServeOptions {
  std::vector<std::string> paths;
  std::string address = "127.0.0.1";
  int port = 8080;
};

/// Prints the page's address and answers until it is interrupted.
int run_serve(const ServeOptions& options);

void describe_serve(CLI::App& command, ServeOptions& options);

}  // namespace continua
