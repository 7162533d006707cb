// Makes a trace smaller as long as its run still does something: what remains is what it takes.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "continua/replay/experiment/shrink_goal.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

struct Shrunk {
  bool done = false;                          ///< the whole trace does it
  std::string instead;                        ///< if not, a sentence on what its run did
  Trace trace;                                ///< if so, the smallest; with the `expect` lines that hold in its run
  std::size_t events_before = 0, events = 0;  ///< that are no `expect` lines
  std::size_t probes = 0;                     ///< replays that it took
};

/// How many events are left after so many probes.
using ShrinkProgress = std::function<void(std::size_t events, std::size_t probes)>;

/// Of the session's trace; `against`: the run log or trace whose run it is to differ from, if that is the goal. First
/// ddmin (ddmin.h) takes events away, to a 1-minimal set of them; then what those that are left say is made smaller
/// where it does not matter, in the same way: the alternatives of n-best lists, the words of utterances, the objects of
/// the header; until nothing more can go. Events keep their times. Of an expectation that is to stay unmet the line
/// itself is kept. Deterministic: of the same there always remains the same. Errors: `against` cannot be read, the goal
/// names a state that the machine does not have, or a line that the trace does not have.
Result<Shrunk> shrink(Session& session, const ShrinkGoal& goal, const ShrinkProgress& progress = {},
                      const std::string& against = "");

}  // namespace continua
