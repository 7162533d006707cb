// A run as a table, for spreadsheets and statistics: one row a record.
#pragma once

#include <iosfwd>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Comma-separated values as RFC 4180 has them, but for lines that end with '\n'. The first row names the columns: `n`,
/// `t`, `kind`, `cause`, then every other member that some record has, in the order in which they come up. Texts stand
/// as they are, lists and objects as JSON, what a record does not have is empty. The header (`run`), which tells of no
/// event, is left out.
Outcome export_csv(const RunIndex& run, std::ostream& out);

}  // namespace continua
