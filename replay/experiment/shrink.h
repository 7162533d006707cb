// Makes a trace smaller as long as its run still meets a goal: the rest is needed for it.
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
  std::string instead;                        ///< if not, a sentence on the deeds of its run
  Trace trace;                                ///< if so, the smallest; with the `expect` lines that hold in its run
  std::size_t events_before = 0, events = 0;  ///< that are no `expect` lines
  std::size_t probes = 0;                     ///< replays that it took
};

/// How many events are left after so many probes.
using ShrinkProgress = std::function<void(std::size_t events, std::size_t probes)>;

/// Shrinks the session's trace; `against`: the run log or trace whose run it is to differ from, if that is the goal.
/// First ddmin (ddmin.h) takes events away, to a 1-minimal set of them. Then the content of the remaining events is
/// made smaller in the same way, where it does not matter: the alternatives of n-best lists, the words of utterances,
/// the objects of the header; until nothing more can go. Events keep their times. An expectation that is to stay unmet
/// keeps its line. Deterministic. Errors: `against` cannot be read, the goal names a state that the machine does not
/// have, or a line that the trace does not have.
Result<Shrunk> shrink(Session& session, const ShrinkGoal& goal, const ShrinkProgress& progress = {},
                      const std::string& against = "");

}  // namespace continua
