// One pass over the lines of a run log: the place of each record, and the few numbers that every view needs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/log_source.h"
#include "continua/replay/log/run_meaning.h"

namespace continua {

/// One line of the log. Its running number `n` is its place in the index.
struct RecordEntry {
  std::uint64_t offset = 0;        ///< of its first byte
  std::uint32_t length = 0;        ///< in bytes, without the line's end
  std::uint16_t kind = 0;          ///< place in ScannedLog::kinds
  std::uint8_t event = 0;          ///< of an event of the trace as it was read, a number for its kind; else 0
  std::uint8_t measured : 1 = 0;   ///< 1: when it happened depends on how long an act took
  std::uint8_t sample : 1 = 0;     ///< 1: an input that says where a hand points; these come by the hundred
  std::uint8_t by_sample : 1 = 0;  ///< 1: such an input, or brought about by one, by however many causes
  std::int64_t cause = -1;         ///< n of the record that brought it about, or -1
  SimTime t{};
  RecordMeaning meaning;
};

/// A record after which the stack's top is known.
struct StackMark {
  std::uint32_t n = 0;
  std::uint32_t depth = 0;  ///< number of symbols: as the record has it, else those from the top down
  std::int64_t top = -1;    ///< id of the top symbol, or -1 for an empty stack
};

/// Where a stack symbol was written, and the one below it (-1 for none).
struct SymbolPlace {
  std::uint32_t n = 0;
  std::uint32_t depth = 1;  ///< number of symbols from this one down
  std::int64_t below = -1;
  std::uint64_t stack = 0;  ///< equal for stacks of equal symbols, in any run
};

/// A record that tells of an act.
struct ActMark {
  std::uint64_t n = 0;
  std::int64_t act = 0;
  std::uint32_t step = 0;   ///< of the act's steps; 0: the act as a whole
  std::uint32_t asked = 0;  ///< 1: it was asked for here
};

/// A transition, or the correction of one: its id, and the states it leads from and to, as places in ScannedLog::names.
struct StepMark {
  std::uint32_t n = 0, id = 0, from = 0, to = 0;
};

/// A log as far as it has been scanned: a value.
struct ScannedLog {
  std::string path;
  std::uint64_t bytes = 0;
  std::vector<RecordEntry> entries;
  std::vector<std::string> kinds;
  std::vector<StackMark> marks;
  std::unordered_map<std::int64_t, SymbolPlace> symbols;  ///< by id
  std::vector<ActMark> acts;
  std::vector<StepMark> steps;
  std::vector<std::string> names;  ///< the ids and states that transitions name
  std::uint64_t last_line = 0;     ///< hash of the last record's line
  std::string trouble;             ///< the fault of the log's end, as a sentence; empty when there is none

  /// Whether the log ends with its `end` record.
  bool complete() const;
  /// The symbol of this id, or nullptr.
  const SymbolPlace* symbol(std::int64_t id) const;
  /// "file:line" of record n.
  std::string where(std::size_t n) const;
};

/// Adds the lines from byte `offset` to the end of the source. A last line cut short is left out (see `trouble`);
/// a source that is empty or no run log is an error, as is a broken line before the last.
Outcome scan_log(const LogSource& source, std::uint64_t offset, ScannedLog& log);

}  // namespace continua
