// A run told in a few sentences, act by act and minute by minute. Reads the log alone.
#pragma once

#include <string>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// {"sentences": [{"text", "n"}], "acts": [{"text", "n", "t", "failed"}], "minutes": [{"text", "n", "from", "to"}]},
/// where `n` is the record that a line is about and times are seconds. Minutes in which nothing was said or done are
/// left out. Errors: of a log that cannot be read.
Result<Json> run_account(const RunIndex& run);

/// The same as lines of at most `width` columns.
std::string account_text(const Json& account, std::size_t width);

}  // namespace continua
