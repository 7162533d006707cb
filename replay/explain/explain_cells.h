// The cells of a stack: every slot of every symbol, since when it has its value, and who looked at it last.
#pragma once

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// The cells of the stack as it stands at the scope's record, top first:
/// {"symbol": id, "slot", "value", "symbols": ids that the symbol's place in the stack has had up to now, the latest
/// first (an earlier id names this cell too), "set": n of the transition or rewrite that gave it its value, or of the
/// symbol that the log begins with, "t": its seconds, "expression": the machine file's expression for the slot there,
/// or null, "changes": n of those that gave it its earlier values, the latest first, "read": n of the last transition
/// or rewrite until now that fired with the slot in its condition, operation or gates while the symbol was on top, or
/// null where there is none nearby, "origin": the source of the value (origin_of); of a value that the machine made by
/// itself the input that it answered, or null}. Of a deep stack the cells near the top alone; histories are followed
/// for some hundred changes.
Json explained_cells(ExplainScope& scope);

/// The value of the slot of the symbol as text, empty where there is none. `cell` is "SYMBOL.SLOT".
std::string cell_value(const RunIndex& run, const std::string& cell);

}  // namespace continua
