// Opens a run log (RUNLOG.md) without turning it into a tree: one pass over the lines keeps where each record
// lies and the few numbers that every view needs. Records are parsed when somebody asks for one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/log_scan.h"

namespace continua {

/// A run log held open. Values are read from the file on demand; reading from several threads is safe.
/// Costs about 60 bytes of memory a record.
class RunIndex {
 public:
  /// Scans the whole file. A last line cut short is left out (see `trouble`); a file that is missing, empty or not a
  /// run log is an error, as is a broken line before the last. The index of a long log is kept next to it, as
  /// PATH.index, and read again as long as the log is the same file; without leave to write there it is not kept.
  static Result<RunIndex> open(const std::string& path);
  /// Of a log held in memory; `name` stands for the file.
  static Result<RunIndex> of_text(std::string text, const std::string& name);

  /// The index of `old`'s log, which has grown: only the new part is read, if the last line of `old` is still in its
  /// place; else as open().
  static Result<RunIndex> grown(const RunIndex& old);

  const std::string& path() const { return log_.path; }
  std::uint64_t bytes() const { return log_.bytes; }

  std::size_t size() const { return log_.entries.size(); }
  const RecordEntry& entry(std::size_t n) const { return log_.entries[n]; }
  const std::vector<std::string>& kinds() const { return log_.kinds; }
  const std::string& kind(std::size_t n) const { return log_.kinds[log_.entries[n].kind]; }
  std::optional<std::size_t> cause(std::size_t n) const;

  /// Running numbers of all records of a kind, in order.
  std::vector<std::size_t> of_kind(std::string_view kind) const;

  /// The line as written. REQUIRES n < size().
  Result<std::string> line(std::size_t n) const;

  /// The same, once it is sure that it is a JSON object. REQUIRES n < size().
  Result<std::string> record_text(std::size_t n) const;

  /// The record parsed. REQUIRES n < size().
  Result<Json> record(std::size_t n) const;

  /// Record 0 parsed, once for all who ask: with the documents of the run it is much larger than the others.
  const Result<Json>& header() const;

  /// Calls `use(n, line)` for those records that are `wanted`, in order, until it gives false. Reads large pieces of
  /// the file: much faster than line() where many are wanted.
  Outcome read_lines(const std::function<bool(std::size_t)>& wanted,
                     const std::function<bool(std::size_t, std::string_view)>& use) const;

  /// Whether the log ends with its `end` record.
  bool complete() const { return log_.complete(); }

  /// The fault of the log's end, as a sentence; empty when there is none.
  const std::string& trouble() const { return log_.trouble; }

  const std::vector<StackMark>& stack_marks() const { return log_.marks; }

  /// The last stack known at record n: a place in stack_marks(), or nothing before the first.
  std::optional<std::size_t> mark_at(std::size_t n) const;

  /// The symbol of this id, or nullptr.
  const SymbolPlace* symbol(std::int64_t id) const { return log_.symbol(id); }

  const std::vector<ActMark>& act_marks() const { return log_.acts; }

  const std::vector<StepMark>& step_marks() const { return log_.steps; }

  /// The ids and states that transitions name.
  const std::vector<std::string>& names() const { return log_.names; }

  /// Ids of the symbols from `top` down. A chain that names an unknown id ends there.
  std::vector<std::int64_t> stack_ids(std::int64_t top) const;

  /// The symbols from `top` down as written: {id, below, slots}, each with `made`, the n of its record.
  Result<Json> snapshot(std::int64_t top) const;

  /// "file:line" of record n.
  std::string where(std::size_t n) const { return log_.where(n); }

 private:
  explicit RunIndex(std::shared_ptr<const LogSource> source, ScannedLog log = {})
      : source_(std::move(source)), log_(std::move(log)) {}
  static Result<RunIndex> scanned(std::shared_ptr<const LogSource> source, const std::string& path);

  struct Header;
  static std::shared_ptr<Header> unread_header();

  std::shared_ptr<const LogSource> source_;
  ScannedLog log_;
  std::shared_ptr<Header> header_ = unread_header();
};

}  // namespace continua
