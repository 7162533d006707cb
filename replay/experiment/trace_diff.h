// The differences of two traces: their headers' parts, and the changes of events from one to the other.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/diff/event_changes.h"
#include "continua/replay/diff/run_diff.h"
#include "continua/replay/diff/run_givens.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

struct TraceDiff {
  bool same = true;
  std::string sentence;                 ///< the first change, and how many more there are
  std::vector<GivenDifference> header;  ///< of kind "header"
  struct Change {
    EventChange::Kind kind;
    std::size_t line_a = 0, line_b = 0;  ///< 0: it is in the other trace only
    RootCause cause;                     ///< the change in words
  };
  std::vector<Change> changes;  ///< in order of time
};

TraceDiff diff_traces(const Trace& a, const Trace& b);

/// A line for each change; `colour` for a terminal.
std::string trace_diff_text(const TraceDiff& diff, bool colour);
std::string trace_diff_markdown(const TraceDiff& diff);
/// {"same", "sentence", "header" [{"what", "a", "b"}], "changes" [{"kind", "line_a", "line_b", "what", "sentence"}]}
Json trace_diff_json(const TraceDiff& diff);

}  // namespace continua
