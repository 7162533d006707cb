// Where a reader going through a run from one event to the next wants to stop.
#pragma once

#include <cstdint>
#include <vector>

#include "continua/replay/log/run_index.h"

namespace continua {

/// The records at which the arrow keys stop, in order: neither the stream of pointing samples nor its refusals, nor its
/// consequences without a change of the stack; nor poses, symbols and other records that only keep the log's account.
std::vector<std::uint32_t> records_worth_stopping_at(const RunIndex& run);

}  // namespace continua
