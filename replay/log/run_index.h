// Opens a run log (RUNLOG.md) without turning it into a tree: one pass over the lines keeps where each record
// lies and the few numbers that every view needs. Records are parsed when somebody asks for one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_meaning.h"

namespace continua {

/// One line of the log. Its running number `n` is its place in the index.
struct RecordEntry {
  std::uint64_t offset = 0;        ///< of its first byte
  std::uint32_t length = 0;        ///< in bytes, without the line's end
  std::uint16_t kind = 0;          ///< place in RunIndex::kinds()
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

/// A transition, or the correction of one: its id, and the states it leads from and to, as places in RunIndex::names().
struct StepMark {
  std::uint32_t n = 0, id = 0, from = 0, to = 0;
};

/// A run log held open. Values are read from the file on demand; reading from several threads is safe.
/// Costs about 60 bytes of memory a record.
class RunIndex {
 public:
  /// A file as far as can be told without reading it: its size, when it was written, and its first and last bytes.
  struct Print {
    std::uint64_t bytes = 0;
    std::int64_t written_ns = 0;
    std::uint64_t ends = 0;
    bool operator==(const Print&) const = default;
  };

  /// Scans the whole file. A last line cut short is left out (see `trouble`); a file that is missing, empty or not a
  /// run log is an error, as is a broken line before the last. The index of a long log is kept next to it, as
  /// PATH.index, and read again as long as the log is the same file; without leave to write there it is not kept.
  static Result<RunIndex> open(const std::string& path);
  /// Of a log held in memory; `name` stands for the file.
  static Result<RunIndex> of_text(std::string text, const std::string& name);

  /// The index of `old`'s log, which has grown: only the new part is read, if the last line of `old` is still in its
  /// place; else as open().
  static Result<RunIndex> grown(const RunIndex& old);

  const std::string& path() const { return path_; }
  std::uint64_t bytes() const { return bytes_; }

  std::size_t size() const { return entries_.size(); }
  const RecordEntry& entry(std::size_t n) const { return entries_[n]; }
  const std::vector<std::string>& kinds() const { return kinds_; }
  const std::string& kind(std::size_t n) const { return kinds_[entries_[n].kind]; }
  std::optional<std::size_t> cause(std::size_t n) const;

  /// Running numbers of all records of a kind, in order.
  std::vector<std::size_t> of_kind(std::string_view kind) const;

  /// The line as written. REQUIRES n < size().
  Result<std::string> line(std::size_t n) const;

  /// The record parsed. REQUIRES n < size().
  Result<Json> record(std::size_t n) const;

  /// Calls `use(n, line)` for those records that are `wanted`, in order, until it gives false. Reads large pieces of
  /// the file: much faster than line() where many are wanted.
  Outcome read_lines(const std::function<bool(std::size_t)>& wanted,
                     const std::function<bool(std::size_t, std::string_view)>& use) const;

  /// Whether the log ends with its `end` record.
  bool complete() const;

  /// The fault of the log's end, as a sentence; empty when there is none.
  const std::string& trouble() const { return trouble_; }

  const std::vector<StackMark>& stack_marks() const { return marks_; }

  /// The last stack known at record n: a place in stack_marks(), or nothing before the first.
  std::optional<std::size_t> mark_at(std::size_t n) const;

  /// The symbol of this id, or nullptr.
  const SymbolPlace* symbol(std::int64_t id) const;

  const std::vector<ActMark>& act_marks() const { return acts_; }

  const std::vector<StepMark>& step_marks() const { return steps_; }

  /// The ids and states that transitions name.
  const std::vector<std::string>& names() const { return names_; }

  /// Ids of the symbols from `top` down. A chain that names an unknown id ends there.
  std::vector<std::int64_t> stack_ids(std::int64_t top) const;

  /// The symbols from `top` down as written: {id, below, slots}, each with `made`, the n of its record.
  Result<Json> snapshot(std::int64_t top) const;

  /// "file:line" of record n.
  std::string where(std::size_t n) const;

 private:
  class Source;
  class File;
  class Text;
  RunIndex() = default;
  static Result<RunIndex> scan(std::shared_ptr<const Source> source, const std::string& path);
  Outcome read_on(std::uint64_t offset);
  bool goes_on_in(const Source& source) const;
  Outcome add_line(std::string_view line, std::uint64_t offset);
  Outcome problem_of(const std::vector<RecordMember>& members, bool whole, std::string_view kind) const;
  void add_marks(const std::vector<RecordMember>& members, std::string_view kind);
  std::uint16_t kind_number(std::string_view kind);
  std::uint32_t name_number(std::string_view value);
  // run_index_file.cpp
  static std::optional<Print> print_of(const std::string& path);
  static std::optional<RunIndex> kept(const std::string& path, const Print& print);
  void keep(const Print& print) const;
  bool consistent() const;

  std::string path_;
  std::shared_ptr<const Source> source_;
  std::uint64_t bytes_ = 0;
  std::vector<RecordEntry> entries_;
  std::vector<std::string> kinds_;
  std::vector<const RecordKind*> record_kinds_;  ///< of each kind, while the log is scanned
  std::vector<StackMark> marks_;
  std::unordered_map<std::int64_t, SymbolPlace> symbols_;  ///< by id
  std::vector<ActMark> acts_;
  std::vector<StepMark> steps_;
  std::vector<std::string> names_;
  struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  std::unordered_map<std::string, std::uint32_t, TextHash, std::equal_to<>> name_numbers_;  ///< while scanned
  std::uint64_t last_line_ = 0;  ///< hash of the last record's line
  std::string trouble_;
};

}  // namespace continua
