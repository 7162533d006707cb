// The text of records as they stand in a log, written member by member: the same bytes as `compact` of their JSON
// (record_json.h), without building it.
#pragma once

#include <string>

#include "continua/replay/log/records.h"

namespace continua::log {

/// Appends the whole line, in the order kind, stamp, members, `measured`, to `line`. To `decision` it appends the part
/// that must be equal on every machine and in every world (RUNLOG.md, `decisions`), the bytes of what DecisionOrder
/// makes of the line; nothing if records of this kind are no decisions.
void add_text(const Stamp& stamp, const Record& record, std::string& line, std::string& decision);

}  // namespace continua::log
