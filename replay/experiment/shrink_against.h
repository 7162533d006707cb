// The run that another one is to differ from, while their trace is made smaller.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "continua/replay/log/run_index.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// An earlier run of the same trace. If the run differs because the machine was another one, which the run's header
/// holds, smaller traces are replayed with that machine too, and the two runs of each are compared. Else the run stays
/// as it is, and the part of the trace before the difference must stay.
class ShrinkAgainst {
 public:
  /// `path`: a run log, or a trace, which is replayed. `now`: the run of the whole trace, as it is now.
  /// Errors: it is neither, or cannot be used.
  static Result<ShrinkAgainst> load(const std::string& path, const std::string& trace_path,
                                    const ReplayOptions& options, const std::string& now);

  /// The reason for which the run of `trace`, with this log, differs: {"kind", "what"} of the diff's cause; nothing
  /// where it does not.
  std::optional<Json> cause(const Trace& trace, const std::string& log);

 private:
  explicit ShrinkAgainst(RunIndex run) : run_(std::move(run)) {}

  RunIndex run_;
  std::optional<Session> then_;  ///< with the machine of the run
};

}  // namespace continua
