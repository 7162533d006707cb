// Hashes of a record's content. Equal hashes mean equal content in any two runs; record numbers, ids and times are left
// out, since they shift when something is added before.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace continua {

struct RecordMeaning {
  std::uint64_t what = 0;   ///< the event: the transition from here to there, the slots of a symbol, the words
  std::uint64_t whole = 0;  ///< with all that it was decided by: candidates, weights, parses, operations
};

/// A member of a record, key and value as written.
struct RecordMember {
  std::string_view key, value;
};

/// The members that count in records of a kind.
struct RecordKind;

/// nullptr for kinds whose records say nothing that counts.
const RecordKind* record_kind(std::string_view name);

RecordMeaning meaning_of(const RecordKind* kind, std::span<const RecordMember> members);

/// Of an event of a trace: its content, without its time. `event` is an object as written.
std::uint64_t meaning_of_event(std::string_view event);

}  // namespace continua
