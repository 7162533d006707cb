// Writes records as they stand in a log, member by member: the same bytes as `compact` of their JSON (record_json.h),
// without building it.
#pragma once

#include <limits>

#include "continua/replay/log/record_text.h"
#include "continua/replay/log/records.h"

namespace continua::log {

class RecordWriter {
 public:
  /// Appends the whole line, in the order kind, stamp, members, `measured`, to `line`. To `decision` it appends the
  /// part that must be equal on every machine and in every world (RUNLOG.md, `decisions`), the bytes of what
  /// DecisionOrder makes of the line; nothing if records of this kind are no decisions.
  void add(const Stamp& stamp, const Record& record, RecordText& line, RecordText& decision);

 private:
  double t_s_ = std::numeric_limits<double>::quiet_NaN();  ///< of the record before
  RecordText t_;                                           ///< its digits: many records have the same time
};

}  // namespace continua::log
