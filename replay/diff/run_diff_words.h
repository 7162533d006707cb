// A difference of two runs in words.
#pragma once

#include <string>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/log/run_words.h"

namespace continua {

/// Of an event of a trace, as a record of a run or a line of the trace has it: “The plate.”, gesture “points”.
std::string event_words(const RunWords& words, const Json& record);

/// The change of an event from one trace to the other. The records (lines) are those of the change; null where it has
/// none, `other_a` the second one under `swapped`.
RootCause change_in_words(const RunWords& words, EventChange::Kind kind, const Json& a, const Json& b,
                          const Json& other_a);

/// The cause of a difference that begins with an input. REQUIRES difference.input
RootCause input_cause(const RunIndex& a, const RunIndex& b, const RunDifference& difference);

/// Where the runs part, why, and the consequences. The transitions are those at the first difference; null: none.
std::string sentence_of(const RunIndex& a, const RunIndex& b, const RunDiff& diff, const Json& transition_a,
                        const Json& transition_b);

}  // namespace continua
