// Records that tell of something, found in a run of any length.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "replay/run/run_index.h"

namespace continua {

/// Letters without their case: of Latin, Greek and Cyrillic.
std::string folded(std::string_view text);

/// Numbers of the records whose kind and label (label_of) contain every word of `text`, whatever the case. Among all
/// records of `kind`; of all kinds if it is "*"; among those worth stopping at if it is empty.
Result<std::vector<std::uint32_t>> run_find(const RunIndex& run, const std::string& text, const std::string& kind);

}  // namespace continua
