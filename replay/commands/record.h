// continua record: a live session, in the browser or through a pipe.
#pragma once

#include <optional>
#include <string>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/listening.h"
#include "continua/replay/live/live_sessions.h"

namespace continua {

struct RecordOptions {
  LiveDefaults live;
  std::string output;  ///< the first session's trace; empty: session.trace.jsonl here, or the next that is free
  ListenOptions listen;
  std::optional<int> port;  ///< none: 8080, and without a server where events are piped and that is in use
};

/// Records until it is interrupted or the pipe on standard input ends. Exit status 1 where an event of the pipe could
/// not be used or an expectation of it was not met.
int run_record(const RecordOptions& options);

void describe_record(CLI::App& command, RecordOptions& options);

}  // namespace continua
