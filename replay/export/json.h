// A run as one JSON document, for people and programs that want one file they can load whole.
#pragma once

#include <iosfwd>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Writes {header, records: […], end} to `out`, indented. Every record that names a stack also carries it
/// expanded as `snapshot`: the slots of its symbols, top first. `end` is null for a log that was cut short.
Outcome export_json(const RunIndex& run, std::ostream& out);

/// The same as text.
Result<std::string> export_json(const RunIndex& run);

}  // namespace continua
