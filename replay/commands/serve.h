// continua serve: the inspector.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/listening.h"

namespace continua {

struct ServeOptions {
  std::vector<std::string> paths;
  ListenOptions listen;
  int port = 8080;
  bool durable = false;
};

/// Prints the page's address and answers until it is interrupted.
int run_serve(const ServeOptions& options);

void describe_serve(CLI::App& command, ServeOptions& options);

}  // namespace continua
