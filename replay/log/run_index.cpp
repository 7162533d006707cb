#include "continua/replay/log/run_index.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_text.h"

namespace continua {
namespace {

using log::name_of;

// We write about 25 kinds. A foreign log may name more; kinds beyond this many share the last number.
constexpr std::size_t most_kinds = 1000;
constexpr std::size_t most_records = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t block_bytes = std::size_t{1} << 20;  // read at once

// The value of a member as written; empty where it is missing.
std::string_view value_in(const std::vector<RecordMember>& members, std::string_view name) {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const RecordMember& one) { return one.key == name; });
  return found == members.end() ? std::string_view() : found->value;
}

// The events of a trace: inputs by their own kinds, the last of which stands for all others, then the other kinds of a
// line.
constexpr std::array<std::string_view, 6> event_kinds{
    "speech", "gesture", "pointing", "", log::Observed::kind.name, log::Expect::kind.name};
constexpr std::uint8_t pointing_event = 3;  // a place in these, from 1

std::uint8_t event_number(std::string_view record_kind, std::string_view event) {
  auto kind = record_kind;
  if (log::is<log::Input>(record_kind)) {
    kind = "";
    scan_members(event, [&](std::string_view key, std::string_view value) {
      if (key == "kind" && is_plain_text(value)) kind = value.substr(1, value.size() - 2);
    });
    if (std::find(event_kinds.begin(), event_kinds.begin() + 3, kind) == event_kinds.begin() + 3) kind = "";
  }
  const auto found = std::find(event_kinds.begin(), event_kinds.end(), kind);
  return found == event_kinds.end() ? std::uint8_t{0} : static_cast<std::uint8_t>(found - event_kinds.begin() + 1);
}

}  // namespace

// Where the log's bytes come from.
class RunIndex::Source {
 public:
  virtual ~Source() = default;
  // Bytes read, fewer than asked for at the end; -1 on failure. Leaves no position behind.
  virtual ssize_t read(std::uint64_t offset, char* into, std::size_t size) const = 0;
};

class RunIndex::Text : public Source {
 public:
  explicit Text(std::string text) : text_(std::move(text)) {}

  ssize_t read(std::uint64_t offset, char* into, std::size_t size) const override {
    if (offset >= text_.size()) return 0;
    return static_cast<ssize_t>(text_.copy(into, size, offset));
  }

 private:
  std::string text_;
};

// A file that stays open, so that a log replaced meanwhile goes on being the one that was indexed.
class RunIndex::File : public Source {
 public:
  explicit File(const std::string& path) : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~File() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool readable() const {
    struct stat status {};
    return descriptor_ >= 0 && ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  }

  ssize_t read(std::uint64_t offset, char* into, std::size_t size) const override {
    std::size_t done = 0;
    while (done < size) {
      const auto got = ::pread(descriptor_, into + done, size - done, static_cast<off_t>(offset + done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return -1;
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    return static_cast<ssize_t>(done);
  }

 private:
  int descriptor_;
};

Result<RunIndex> RunIndex::open(const std::string& path) {
  const auto file = std::make_shared<const File>(path);
  if (!file->readable()) return Error{path, "cannot be read; expected a run log"};
  const auto print = print_of(path);
  if (print)
    if (auto known = kept(path, *print)) {
      known->source_ = file;
      return *std::move(known);
    }
  auto index = scan(file, path);
  // Kept only if the file did not change meanwhile.
  if (index && print && print == print_of(path)) index->keep(*print);
  return index;
}

Result<RunIndex> RunIndex::of_text(std::string text, const std::string& name) {
  return scan(std::make_shared<const Text>(std::move(text)), name);
}

Result<RunIndex> RunIndex::scan(std::shared_ptr<const Source> source, const std::string& path) {
  RunIndex index;
  index.path_ = path;
  index.source_ = std::move(source);
  if (auto problem = index.read_on(0)) return *problem;
  return index;
}

Result<RunIndex> RunIndex::grown(const RunIndex& old) {
  const auto file = std::make_shared<const File>(old.path_);
  if (!file->readable() || old.complete() || !old.goes_on_in(*file)) return open(old.path_);
  RunIndex index = old;
  index.source_ = file;
  index.trouble_.clear();
  const auto& last = index.entries_.back();
  if (auto problem = index.read_on(last.offset + last.length + 1)) return *problem;
  return index;
}

// Whether the last line of this index is still there as a whole line.
bool RunIndex::goes_on_in(const Source& source) const {
  const auto& last = entries_.back();
  std::string line(last.length + std::size_t{1}, '\0');
  if (source.read(last.offset, line.data(), line.size()) != static_cast<ssize_t>(line.size())) return false;
  return line.back() == '\n' && hash_of(std::string_view(line).substr(0, last.length)) == last_line_;
}

// Adds the lines from `offset` to the end.
Outcome RunIndex::read_on(std::uint64_t offset) {
  for (auto number = record_kinds_.size(); number < kinds_.size(); ++number)
    record_kinds_.push_back(record_kind(kinds_[number]));
  for (std::uint32_t number = 0; number < names_.size(); ++number) name_numbers_.emplace(names_[number], number);
  std::string held;                // bytes that have been read and not yet used
  std::uint64_t held_at = offset;  // where it begins in the file
  std::size_t searched = 0;        // no line's end before this place
  for (;;) {
    const auto kept = held.size();
    held.resize(kept + block_bytes);
    const auto got = source_->read(held_at + kept, held.data() + kept, block_bytes);
    if (got < 0) return Error{path_, fmt::format("cannot be read: {}", std::strerror(errno))};
    held.resize(kept + static_cast<std::size_t>(got));
    std::size_t from = 0;
    for (auto end = held.find('\n', searched); end != std::string::npos; end = held.find('\n', from)) {
      const std::string_view line(held.data() + from, end - from);
      if (auto problem = add_line(line, held_at + from)) return *problem;
      from = end + 1;
    }
    held.erase(0, from);
    held_at += from;
    searched = held.size();
    if (static_cast<std::size_t>(got) < block_bytes) break;
  }
  bytes_ = held_at + held.size();
  if (bytes_ == 0) return Error{path_, "the file is empty; expected a run log"};
  // The rest has no line's end: the writer was stopped in the middle of it. It may be a whole record all the same.
  if (!held.empty() && (!Json::accept(held) || add_line(held, held_at))) {
    if (entries_.empty())
      return Error{path_ + ":1", "not a run log: the first line is not a whole record of kind 'run'"};
    trouble_ = fmt::format("Line {} is cut short; the log is shown up to record {}.", size() + 1, size() - 1);
  } else if (!complete()) {
    trouble_ = fmt::format("The log has no end record: the run was cut short after record {}.", size() - 1);
  }
  record_kinds_.clear();
  name_numbers_.clear();
  const auto last = line(size() - 1);
  if (!last) return last.error();
  last_line_ = hash_of(*last);
  return std::nullopt;
}

std::uint16_t RunIndex::kind_number(std::string_view kind) {
  const auto found = std::find_if(kinds_.begin(), kinds_.end(), [&](const std::string& known) {
    return known.size() == kind.size() && known[0] == kind[0] && known == kind;
  });
  if (found != kinds_.end()) return static_cast<std::uint16_t>(found - kinds_.begin());
  if (kinds_.size() >= most_kinds) return static_cast<std::uint16_t>(kinds_.size() - 1);
  kinds_.emplace_back(kind);
  record_kinds_.push_back(record_kind(kind));
  return static_cast<std::uint16_t>(kinds_.size() - 1);
}

// `value` as written.
std::uint32_t RunIndex::name_number(std::string_view value) {
  const bool plain = is_plain_text(value);
  const auto written = plain ? std::string() : text_in(value);
  const std::string_view name = plain ? value.substr(1, value.size() - 2) : std::string_view(written);
  const auto found = name_numbers_.find(name);
  if (found != name_numbers_.end()) return found->second;
  const auto number = static_cast<std::uint32_t>(names_.size());
  names_.emplace_back(name);
  name_numbers_.emplace(name, number);
  return number;
}

Outcome RunIndex::add_line(std::string_view line, std::uint64_t offset) {
  const auto n = entries_.size();
  if (n >= most_records) return Error{where(n), "more records than this program reads"};
  thread_local std::vector<RecordMember> members;
  members.clear();
  const bool whole = scan_members(line, [&](std::string_view key, std::string_view value) {
    members.push_back({key, value});
  });
  const auto written_kind = value_in(members, "kind");
  const bool named = written_kind.size() > 2 && written_kind.front() == '"';
  const auto kind = named ? written_kind.substr(1, written_kind.size() - 2) : std::string_view();
  if (auto problem = problem_of(members, whole, kind)) return problem;
  RecordEntry entry;
  entry.offset = offset;
  entry.length = static_cast<std::uint32_t>(line.size());
  entry.kind = kind_number(kind);
  entry.t = SimTime::from_seconds(*number_in<double>(value_in(members, name_of(&log::Stamp::t_s))));
  entry.measured = value_in(members, name_of(&log::Stamp::measured)) == "true";
  entry.cause = number_in<std::int64_t>(value_in(members, name_of(&log::Stamp::cause))).value_or(-1);
  if (entry.cause >= static_cast<std::int64_t>(n)) entry.cause = -1;
  if (const auto number = event_number(kind, value_in(members, name_of(&log::Input::event)))) {
    const auto in_trace = value_in(members, name_of(&log::Input::line));
    if (!in_trace.empty() && in_trace != "null") entry.event = number;
    entry.sample = log::is<log::Input>(kind) && number == pointing_event;
  }
  entry.by_sample = entry.sample || (entry.cause >= 0 && entries_[static_cast<std::size_t>(entry.cause)].by_sample);
  entry.meaning = meaning_of(record_kinds_[entry.kind], members);
  entries_.push_back(entry);
  add_marks(members, kind);
  return std::nullopt;
}

// A sentence if these are not the members of the next record.
Outcome RunIndex::problem_of(const std::vector<RecordMember>& members, bool whole, std::string_view kind) const {
  const auto n = entries_.size();
  if (n == 0 && (!whole || !log::is<log::Run>(kind)))
    return Error{where(0), "not a run log: the first line is not a whole record of kind 'run'"};
  if (n == 0 && number_in<double>(value_in(members, name_of(&log::Run::version))).value_or(0) != 1)
    return Error{where(0), "a run log of another version; this program reads version 1"};
  if (!whole) return Error{where(n), "not a JSON object on one line; expected a record"};
  if (kind.empty()) return Error{where(n), "a record without 'kind'"};
  const auto number = number_in<std::size_t>(value_in(members, name_of(&log::Stamp::n)));
  if (!number) return Error{where(n), "a record without its number 'n'"};
  if (number != n)
    return Error{where(n),
                 fmt::format("record number {} where {} was expected: lines are missing or out of order", *number, n)};
  if (!number_in<double>(value_in(members, name_of(&log::Stamp::t_s))))
    return Error{where(n), "a record without its time 't' in seconds"};
  return std::nullopt;
}

// Notes the values of the last record by which other parts of a log are found.
void RunIndex::add_marks(const std::vector<RecordMember>& members, std::string_view kind) {
  const auto n = static_cast<std::uint32_t>(entries_.size() - 1);
  const auto value = [&](auto member) { return value_in(members, name_of(member)); };
  // A symbol lies above an older one: a chain can only lead down, even in a broken file.
  if (log::is<log::Symbol>(kind)) {
    const auto id = number_in<std::int64_t>(value(&log::Symbol::id));
    const auto below = number_in<std::int64_t>(value(&log::Symbol::below));
    const auto* lower = below ? symbol(*below) : nullptr;
    const std::array<std::uint64_t, 2> stack{lower ? lower->stack : 0, hash_of(value(&log::Symbol::slots))};
    if (id && *id >= 0)
      symbols_.try_emplace(*id, SymbolPlace{n, lower ? lower->depth + 1 : 1, lower ? *below : -1,
                                            hash_of({reinterpret_cast<const char*>(stack.data()), sizeof stack})});
  }
  // Kinds that change the stack name its top by the same member.
  if (const auto top_value = value(&log::Transition::stack); !top_value.empty()) {
    const auto top = number_in<std::int64_t>(top_value).value_or(-1);
    const auto* symbol_on_top = symbol(top);
    const auto depth = number_in<std::uint32_t>(value(&log::Transition::depth));
    marks_.push_back({n, depth.value_or(symbol_on_top ? symbol_on_top->depth : 0), top});
  }
  if (log::is_any<log::Transition, log::Correction>(kind))
    steps_.push_back({n, name_number(value(&log::Transition::id)), name_number(value(&log::Transition::from)),
                      name_number(value(&log::Transition::to))});
  if (const auto act = number_in<std::int64_t>(value(&log::Act::act)); act && log::is<log::Act>(kind)) {
    const auto step = number_in<std::int64_t>(value(&log::Act::step)).value_or(0);
    acts_.push_back({n, *act, static_cast<std::uint32_t>(std::max<std::int64_t>(step, 0)),
                     text_in(value(&log::Act::status)) == log::asked});
  }
}

std::optional<std::size_t> RunIndex::cause(std::size_t n) const {
  if (entries_[n].cause < 0) return std::nullopt;
  return static_cast<std::size_t>(entries_[n].cause);
}

std::vector<std::size_t> RunIndex::of_kind(std::string_view kind) const {
  std::vector<std::size_t> found;
  const auto place = std::find(kinds_.begin(), kinds_.end(), kind);
  if (place == kinds_.end()) return found;
  const auto number = static_cast<std::uint16_t>(place - kinds_.begin());
  for (std::size_t n = 0; n < entries_.size(); ++n)
    if (entries_[n].kind == number) found.push_back(n);
  return found;
}

Result<std::string> RunIndex::line(std::size_t n) const {
  const auto& entry = entries_[n];
  std::string text(entry.length, '\0');
  if (source_->read(entry.offset, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    return Error{where(n), "cannot be read any more: the file has changed since it was opened"};
  return text;
}

Outcome RunIndex::read_lines(const std::function<bool(std::size_t)>& wanted,
                             const std::function<bool(std::size_t, std::string_view)>& use) const {
  std::string block;
  std::uint64_t block_at = 0;  // where it begins in the file
  for (std::size_t n = 0; n < entries_.size(); ++n) {
    if (!wanted(n)) continue;
    const auto& entry = entries_[n];
    if (entry.offset < block_at || entry.offset + entry.length > block_at + block.size()) {
      block.resize(std::max<std::size_t>(block_bytes, entry.length));
      block_at = entry.offset;
      const auto got = source_->read(block_at, block.data(), block.size());
      block.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
      if (block.size() < entry.length)
        return Error{where(n), "cannot be read any more: the file has changed since it was opened"};
    }
    if (!use(n, std::string_view(block).substr(entry.offset - block_at, entry.length))) break;
  }
  return std::nullopt;
}

Result<Json> RunIndex::record(std::size_t n) const {
  auto text = line(n);
  if (!text) return text.error();
  auto parsed = Json::parse(*text, nullptr, false);
  if (parsed.is_discarded() || !parsed.is_object()) return Error{where(n), "not valid JSON; expected a record"};
  return parsed;
}

bool RunIndex::complete() const { return !entries_.empty() && log::is<log::End>(kind(entries_.size() - 1)); }

std::optional<std::size_t> RunIndex::mark_at(std::size_t n) const {
  const auto after = std::upper_bound(marks_.begin(), marks_.end(), n,
                                      [](std::size_t number, const StackMark& mark) { return number < mark.n; });
  if (after == marks_.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - marks_.begin()) - 1;
}

const SymbolPlace* RunIndex::symbol(std::int64_t id) const {
  const auto found = symbols_.find(id);
  return found == symbols_.end() ? nullptr : &found->second;
}

std::vector<std::int64_t> RunIndex::stack_ids(std::int64_t top) const {
  std::vector<std::int64_t> ids;
  for (auto found = symbols_.find(top); found != symbols_.end(); found = symbols_.find(found->second.below))
    ids.push_back(found->first);
  return ids;
}

Result<Json> RunIndex::snapshot(std::int64_t top) const {
  Json stack = Json::array();
  for (const auto id : stack_ids(top)) {
    const auto& place = symbols_.at(id);
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

std::string RunIndex::where(std::size_t n) const { return fmt::format("{}:{}", path_, n + 1); }

}  // namespace continua
