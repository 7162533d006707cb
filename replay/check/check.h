// Whether a trace still goes as it was approved: its replay, its expectations and its approved run.
#pragma once

#include <optional>
#include <string>

#include "continua/replay/check/run_approved.h"
#include "continua/replay/diff/run_diff.h"
#include "continua/replay/session/session.h"

namespace continua {

enum class Verdict {
  same,
  same_decisions,
  unapproved,  ///< there is no approved run
  changed,
  stale,
  broken,  ///< the trace cannot be replayed, an expectation is not met, or the approved run cannot be read
};

/// "same", "same decisions", "new", "changed", "stale", "broken".
const char* name_of(Verdict verdict);
bool is_failure(Verdict verdict);
/// Whether approving would put it right.
bool can_be_approved(Verdict verdict);

/// Two whole logs and their differences.
struct ComparedRuns {
  RunIndex approved, run;
  RunDiff diff;
};

struct TraceCheck {
  Verdict verdict = Verdict::same;
  std::string reason;                 ///< why not the same; one line, or empty
  int expectations = 0;               ///< how many there are
  std::optional<Error> warning = {};  ///< of its scene
  std::size_t line = 0;               ///< of the trace: where it fails; 0: not known, or it does not
  std::string run;                    ///< the log of the replay, unless it is the same or there is none
  std::optional<ApprovedRun> approved;
  std::optional<ComparedRuns> compared;  ///< where both are whole logs, and not the same
};

/// Replays a trace and compares it with its approved run.
TraceCheck check_trace(const std::string& trace_path, const ReplayOptions& options);

/// Fills in `compared` and `line`, where there are two logs to compare and it has not been done. The error is of one
/// that cannot be read.
Outcome compare(TraceCheck& check);

}  // namespace continua
