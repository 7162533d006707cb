// continua listen: a recogniser's output on standard input, as it comes, as events for `continua record`.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"

namespace continua {

struct ListenFilterOptions {
  std::string from;         ///< the recogniser's format
  std::string camera = {};  ///< the file of the recogniser's camera; empty: none
  bool now = false;         ///< events happen as they arrive, whatever times the recogniser tells
};

/// Events go to standard output, a line each, as soon as they are known. Parts of the input that cannot be used are
/// told on standard error, and are passed over; the exit status is then 1.
int run_listen(const ListenFilterOptions& options);

void describe_listen(CLI::App& command, ListenFilterOptions& options);

}  // namespace continua
