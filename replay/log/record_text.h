// The text of records as they stand in a log, written member by member: the same bytes as `compact` of their JSON
// (record_json.h), without building it.
#pragma once

#include <optional>
#include <string>

#include "continua/replay/log/records.h"

namespace continua::log {

/// The whole line: in the order kind, stamp, members, `measured`.
std::string text_of(const Stamp& stamp, const Record& record);

/// The part of the record that must be equal on every machine and in every world (RUNLOG.md, `decisions`): the bytes of
/// what DecisionOrder makes of the line. Nothing if records of its kind are no decisions.
std::optional<std::string> decision_text_of(const Stamp& stamp, const Record& record);

}  // namespace continua::log
