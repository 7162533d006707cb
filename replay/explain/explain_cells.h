// The cells of a stack: every slot of every symbol, since when it has its value, and who looked at it last.
#pragma once

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// The cells of the stack as it stands at the scope's record, top first:
/// {"symbol": id, "slot", "value", "symbols": ids that the symbol's place in the stack has had up to now, the latest
/// first (a cell that is named by an earlier one is this one), "set": n of the transition or rewrite that gave it its
/// value, or of the symbol that the log begins with, "t": its seconds, "expression": what the machine file has for the
/// slot there, or null, "changes": n of those that gave it its values before, the latest first, "read": n of the last
/// transition or rewrite until now that fired with the slot in its condition, operation or gates while the symbol was
/// on top, or null where there is none nearby, "origin": where the value is from (origin_of); of what the machine
/// came up with by itself the input that it answered, or null}. Of a deep stack the cells near the top alone; histories
/// are followed for some hundred changes.
Json explained_cells(ExplainScope& scope);

/// The value of the slot of the symbol as text, empty where there is none. `cell` is "SYMBOL.SLOT".
std::string cell_value(const RunIndex& run, const std::string& cell);

}  // namespace continua
