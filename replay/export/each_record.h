// The records of a run one after the other, for exporters that write each as it comes.
#pragma once

#include <functional>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Calls `use` with each record but the header, parsed. Error: a line is no JSON object, or cannot be read.
Outcome each_record(const RunIndex& run, const std::function<void(const Json& record)>& use);

}  // namespace continua
