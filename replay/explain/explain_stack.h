// What a record's turn did to the stack, and where each changed slot has its value from.
#pragma once

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// {"before": depth, "after": depth, "since": n of the last record before the change, "symbols": as run_stack gives
/// them, top first, each change of a slot {"was", "now", "by": n of the transition or rewrite that set it, or null,
/// "expression": what the machine file has for the slot there, or null, "application": n of the one that made the
/// value, or null, "origin": where it is from, or null where `by` tells all there is}, "removed": symbols that are
/// gone}. Of a transition or rewrite: what it changed; of anything else: what its whole turn changed.
Result<Json> explained_stack(ExplainScope& scope);

}  // namespace continua
