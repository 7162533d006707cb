// Records that tell of something, found in a run of any length.
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Numbers of the records whose kind and label, as logged or in words (run_labels.h), contain every word of `text`,
/// whatever the case. Among all records of `kind`; of all kinds if it is "*"; among those worth stopping at if it is
/// empty.
Result<std::vector<std::uint32_t>> run_find(const RunIndex& run, const std::string& text, const std::string& kind);

}  // namespace continua
