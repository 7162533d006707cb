// A run as a table, for spreadsheets and statistics: one row a record.
#pragma once

#include <iosfwd>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Comma-separated values by RFC 4180, except that lines end with '\n'. The first row names the columns: `n`, `t`,
/// `kind`, `cause`, then every other member of any record, in order of first appearance. Texts stand as they are, lists
/// and objects as JSON, a missing member is empty. The header (`run`), which tells of no event, is left out.
Outcome export_csv(const RunIndex& run, std::ostream& out);

}  // namespace continua
