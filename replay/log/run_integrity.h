// Whether a run log is what was written: its chain of digests and what its last line states (RECORDS.md, `block`,
// `end`).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

/// All that is not as it was written, at "path:line": the first damaged block and how many more there are; otherwise
/// what the last line states and its records do not. A log cut short is whole as far as its last block tells.
/// `text` is the whole file.
std::vector<Error> integrity_problems(std::string_view text, const std::string& path);

}  // namespace continua
