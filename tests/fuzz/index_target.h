// The index beside a long log, which a stranger may hand over with the log: FuzzTarget's functions for it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

class RunIndex;

/// Reads all short records and all stacks that a log's index leads to.
void read_whole(const RunIndex& run);

/// Reads a long log by an index that says `bytes` of it. The beginning, which names the format and the log, and the
/// digest at the end are always right: without them an index is not looked at.
void read_index(std::string_view bytes);

/// What the true index of that log says.
std::vector<std::string> index_seeds();

}  // namespace continua
