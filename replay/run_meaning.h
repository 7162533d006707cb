// What a record of a run log says, as numbers that are equal where records of any two runs say the same: without
// running numbers, ids and times, which shift when something is added before.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace continua {

struct RecordMeaning {
  std::uint64_t what = 0;   ///< what happened: the transition from here to there, the slots of a symbol, what was said
  std::uint64_t whole = 0;  ///< with all that it was decided by: candidates, weights, parses, operations
};

/// A member of a record, key and value as written.
struct RecordMember {
  std::string_view key, value;
};

RecordMeaning meaning_of(std::string_view kind, std::span<const RecordMember> members);

/// Of an event of a trace: what it says, whenever it does. `event` is an object as written.
std::uint64_t meaning_of_event(std::string_view event);

}  // namespace continua
