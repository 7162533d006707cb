// A record and its reason, in a sentence.
#pragma once

#include <string>

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// "At 5.05 s the avatar does put(plate, <-0.1, -0.15, 0>), because the human said “Put it there.” (4.0 s) with
/// pointing right [-0.1,-0.15] (3.8 s), after “The plate.” (1.0 s)." `act` is the result of explained_act, or null.
std::string headline(ExplainScope& scope, const Json& act);

/// How an act went: {"act": its number, "program", "asked": n, "records": [{"n", "t", "status", "step": or null,
/// "program", "result"}] of all its states, "outcome": its last status or null while it has not ended,
/// "sentence": how it went}; null where record n is of no act.
Json explained_act(ExplainScope& scope, std::size_t n);

}  // namespace continua
