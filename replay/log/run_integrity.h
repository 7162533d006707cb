// Whether a run log is as it was written: its chain of digests and the statements of its last line (RECORDS.md,
// `block`, `end`).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

/// All differences from the log as written, at "path:line": the first damaged block and the number of others; otherwise
/// the statements of the last line that its records contradict. A log cut short is whole as far as its last block
/// tells. `text` is the whole file.
std::vector<Error> integrity_problems(std::string_view text, const std::string& path);

}  // namespace continua
