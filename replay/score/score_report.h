// Scores of traces as a table, as JSON and as Markdown.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/score/score.h"

namespace continua {

struct ScoreReport {
  std::string variant;  ///< how far the observed moves led the runs: "free", "world" or "teacher"
  std::vector<TraceScore> traces;

  Score total() const;
  ScoreOfKinds kinds() const;  ///< of all traces
};

/// The counts by their names, as in score_json().
Json json_of(const Score& score);

/// One of the "traces" of score_json().
Json json_of(const TraceScore& trace);

/// Tables of the traces and of the kinds of moves, and the misses: of each trace the first few, or all.
std::string score_text(const ScoreReport& report, bool all_misses);

/// {"variant", "traces": [{"trace", "run" or null, the counts, "kinds": [{"kind", "speaking", "exact", "lax",
/// "template"}], "misses": [{"t", "line", "record", "input", "observed": [{"channel", "content"}], "produced",
/// "level"}]
/// }], "total": {the counts}, "kinds"}. The counts: "inputs", "speaking", "exact", "lax", "template", "answered",
/// "spurious", "right", "f1", "samples", "silent_samples".
Json score_json(const ScoreReport& report);

/// The tables.
std::string score_markdown(const ScoreReport& report);

}  // namespace continua
