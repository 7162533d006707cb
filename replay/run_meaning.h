// What a record of a run log says, as numbers that are equal where records of any two runs say the same: without running
// numbers, ids and times, which shift when something is added before.
#pragma once

#include <cstdint>
#include <string_view>

namespace continua {

struct RecordMeaning {
  std::uint64_t what = 0;   ///< what happened: the transition from here to there, the slots of a symbol, what was said
  std::uint64_t whole = 0;  ///< with all that it was decided by: candidates, weights, parses, operations
};

/// `line` is the record as written, an object of this kind.
RecordMeaning meaning_of(std::string_view kind, std::string_view line);

/// Of an event of a trace: what it says, whenever it does. `event` is an object as written.
std::uint64_t meaning_of_event(std::string_view event);

}  // namespace continua
