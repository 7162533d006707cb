#include "continua/replay/log/run_index.h"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/records.h"
#include "continua/replay/log/run_index_file.h"

namespace continua {
namespace {

using log::name_of;

// Whether the last line of the scan is still there as a whole line.
bool goes_on_in(const LogSource& source, const ScannedLog& log) {
  const auto& last = log.entries.back();
  std::string line(last.length + std::size_t{1}, '\0');
  if (source.read(last.offset, line.data(), line.size()) != static_cast<ssize_t>(line.size())) return false;
  return line.back() == '\n' && hash_of(std::string_view(line).substr(0, last.length)) == log.last_line;
}

// Whether the line is that of record n, as it is unless a kept index lies about the log.
bool is_line_of(std::size_t n, std::string_view line) {
  // The number comes second in our logs, and longer than this only behind a long kind.
  constexpr std::size_t usual_begin = 100;
  const auto number = fmt::format("\"{}\":{}", name_of(&log::Stamp::n), n);
  const auto at = line.substr(0, usual_begin).find(number);
  if (at != line.npos && at + number.size() < line.size() && line[at + number.size()] == ',') return true;
  return number_in<std::size_t>(member_in(line, name_of(&log::Stamp::n))) == n;
}

Error no_record(const RunIndex& run, std::size_t n) { return {run.where(n), "not valid JSON; expected a record"}; }

Error lying_index(const RunIndex& run, std::size_t n) {
  return {run.where(n), fmt::format("is not where {}.index has it; remove that file, and it is made anew", run.path())};
}

}  // namespace

Result<RunIndex> RunIndex::open(const std::string& path) {
  const auto file = source_of_log(path);
  if (!file) return file.error();
  const auto print = print_of(path);
  if (print)
    if (auto known = kept_scan(path, *print)) return RunIndex(*file, *std::move(known));
  auto index = scanned(*file, path);
  // Kept only if the file did not change meanwhile.
  if (index && print && print == print_of(path)) keep_scan(index->log_, *print);
  return index;
}

Result<RunIndex> RunIndex::of_text(std::string text, const std::string& name) {
  return scanned(source_of_text(std::move(text)), name);
}

Result<RunIndex> RunIndex::scanned(std::shared_ptr<const LogSource> source, const std::string& path) {
  RunIndex index(std::move(source));
  index.log_.path = path;
  if (auto problem = scan_log(*index.source_, 0, index.log_)) return *problem;
  return index;
}

Result<RunIndex> RunIndex::grown(const RunIndex& old) {
  const auto file = source_of_log(old.path());
  if (!file || old.complete() || !goes_on_in(**file, old.log_)) return open(old.path());
  RunIndex index(*file, old.log_);
  index.header_ = old.header_;
  index.log_.trouble.clear();
  const auto& last = index.log_.entries.back();
  if (auto problem = scan_log(**file, last.offset + last.length + 1, index.log_)) return *problem;
  return index;
}

struct RunIndex::Header {
  std::once_flag asked;
  std::optional<Result<Json>> record;
};

std::shared_ptr<RunIndex::Header> RunIndex::unread_header() { return std::make_shared<Header>(); }

const Result<Json>& RunIndex::header() const {
  std::call_once(header_->asked, [this] { header_->record = record(0); });
  return *header_->record;
}

std::optional<std::size_t> RunIndex::cause(std::size_t n) const {
  if (log_.entries[n].cause < 0) return std::nullopt;
  return static_cast<std::size_t>(log_.entries[n].cause);
}

std::vector<std::size_t> RunIndex::of_kind(std::string_view kind) const {
  std::vector<std::size_t> found;
  const auto place = std::find(log_.kinds.begin(), log_.kinds.end(), kind);
  if (place == log_.kinds.end()) return found;
  const auto number = static_cast<std::uint16_t>(place - log_.kinds.begin());
  for (std::size_t n = 0; n < log_.entries.size(); ++n)
    if (log_.entries[n].kind == number) found.push_back(n);
  return found;
}

Result<std::string> RunIndex::line(std::size_t n) const {
  const auto& entry = log_.entries[n];
  std::string text(entry.length, '\0');
  const auto got = source_->read(entry.offset, text.data(), text.size());
  if (got != static_cast<ssize_t>(text.size())) return Error{where(n), reading_problem(got)};
  if (!is_line_of(n, text)) return lying_index(*this, n);
  return text;
}

Outcome RunIndex::read_lines(const std::function<bool(std::size_t)>& wanted,
                             const std::function<bool(std::size_t, std::string_view)>& use) const {
  std::string block;
  std::uint64_t block_at = 0;  // where it begins in the file
  for (std::size_t n = 0; n < log_.entries.size(); ++n) {
    if (!wanted(n)) continue;
    const auto& entry = log_.entries[n];
    if (entry.offset < block_at || entry.offset + entry.length > block_at + block.size()) {
      block.resize(std::max<std::size_t>(block_bytes, entry.length));
      block_at = entry.offset;
      const auto got = source_->read(block_at, block.data(), block.size());
      block.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
      if (block.size() < entry.length) return Error{where(n), reading_problem(got)};
    }
    const auto line = std::string_view(block).substr(entry.offset - block_at, entry.length);
    if (!is_line_of(n, line)) return lying_index(*this, n);
    if (!use(n, line)) break;
  }
  return std::nullopt;
}

Result<std::string> RunIndex::record_text(std::size_t n) const {
  auto text = line(n);
  if (text && (!text->starts_with('{') || !Json::accept(*text))) return no_record(*this, n);
  return text;
}

Result<Json> RunIndex::record(std::size_t n) const {
  auto text = line(n);
  if (!text) return text.error();
  auto parsed = Json::parse(*text, nullptr, false);
  if (parsed.is_discarded() || !parsed.is_object()) return no_record(*this, n);
  return parsed;
}

std::optional<std::size_t> RunIndex::mark_at(std::size_t n) const {
  const auto after = std::upper_bound(log_.marks.begin(), log_.marks.end(), n,
                                      [](std::size_t number, const StackMark& mark) { return number < mark.n; });
  if (after == log_.marks.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - log_.marks.begin()) - 1;
}

std::vector<std::int64_t> RunIndex::stack_ids(std::int64_t top) const {
  std::vector<std::int64_t> ids;
  for (auto found = log_.symbols.find(top); found != log_.symbols.end(); found = log_.symbols.find(found->second.below))
    ids.push_back(found->first);
  return ids;
}

Result<Json> RunIndex::snapshot(std::int64_t top) const {
  Json stack = Json::array();
  for (const auto id : stack_ids(top)) {
    const auto& place = log_.symbols.at(id);
    auto symbol = record(place.n);
    if (!symbol) return symbol.error();
    Json slots = symbol->value(name_of(&log::Symbol::slots), Json::object());
    stack.push_back(Json{{"id", id},
                         {"below", place.below < 0 ? Json() : Json(place.below)},
                         {"made", place.n},
                         {"slots", std::move(slots)}});
  }
  return stack;
}

}  // namespace continua
