// How far a run's avatar did what another was observed to do, worked out from the run's log.
#pragma once

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// {"answers": inputs with an observed answer, "alike": those of them that the run answered at least `lax` alike,
/// "misses": [n, …]}, counted as `continua score` does (SCORE.md). A miss is told by the first record of its observed
/// answer; where nothing was observed, of the run's. Null if the log has no observed moves.
Result<Json> run_agreement(const RunIndex& run);

}  // namespace continua
