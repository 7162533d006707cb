// Events on standard input, the avatar's moves on standard output.
#pragma once

#include <atomic>
#include <string>

#include "continua/replay/live/live_sessions.h"

namespace continua {

/// Whether standard input is a pipe, a socket or a file rather than a terminal or nothing at all.
bool is_piped();

struct PipeSummary {
  std::size_t events = 0, refused = 0;
  bool broke = false;                    ///< the session ended since it could not be written any further
  std::optional<ReplaySummary> summary;  ///< none: there was no session
  ListedSession session;                 ///< where there was one
};

/// Reads JSON Lines to their end, or until `stop`: at first perhaps a trace's header, then events, which go to one
/// session as they come. Lines that cannot be used are told on standard error. No more
/// is read once the session has broken off. `begin_empty`: there is a session even
/// if there is no line. Error: the session could not be begun.
Result<PipeSummary> pipe_events(LiveSessions& sessions, bool begin_empty, const std::atomic<bool>& stop);

}  // namespace continua
