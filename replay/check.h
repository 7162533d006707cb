// Whether a trace still goes as it was approved: its replay, its expectations and the run beside it.
#pragma once

#include <optional>
#include <string>

#include "replay/run_approved.h"
#include "replay/session.h"

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
const char* text(Verdict verdict);
bool is_failure(Verdict verdict);
/// Whether approving would put it right.
bool can_be_approved(Verdict verdict);

struct TraceCheck {
  Verdict verdict = Verdict::same;
  std::string reason;                 ///< why not the same; one line, or empty
  int expectations = 0;               ///< how many there are
  std::optional<Error> warning = {};  ///< of its scene
  std::string run;                    ///< the log of the replay, where it can be approved
  std::optional<ApprovedRun> approved;
};

/// Replays a trace and holds it against what is approved.
TraceCheck check_trace(const std::string& trace_path, const ReplayOptions& options);

}  // namespace continua
