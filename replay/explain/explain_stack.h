// The changes of the stack in a record's turn, and the source of each changed slot's value.
#pragma once

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// {"before": depth, "after": depth, "since": n of the last record before the change, "symbols": in the form of
/// run_stack, top first, each change of a slot {"was", "now", "by": n of the transition or rewrite that set it, or
/// null, "expression": the machine file's expression for the slot there, or null, "application": n of the one that made
/// the value, or null, "origin": its source, or null where `by` tells all there is}, "removed": symbols that are gone}.
/// Of a transition or rewrite: its own changes; of anything else: those of its whole turn.
Result<Json> explained_stack(ExplainScope& scope);

}  // namespace continua
