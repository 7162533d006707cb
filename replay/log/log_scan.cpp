#include "continua/replay/log/log_scan.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_text.h"

namespace continua {
namespace {

using log::name_of;

// We write about 25 kinds. A foreign log may name more; kinds beyond this many share the last number.
constexpr std::size_t most_kinds = 1000;
constexpr std::size_t most_records = std::numeric_limits<std::int32_t>::max();

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

class Scan {
 public:
  Scan(const LogSource& source, ScannedLog& log) : source_(source), log_(log) {
    for (const auto& kind : log_.kinds) record_kinds_.push_back(record_kind(kind));
    for (std::uint32_t number = 0; number < log_.names.size(); ++number)
      name_numbers_.emplace(log_.names[number], number);
  }

  Outcome read_on(std::uint64_t offset);

 private:
  Outcome note_last_line();
  Outcome add_line(std::string_view line, std::uint64_t offset);
  Outcome problem_of(const std::vector<RecordMember>& members, bool whole, std::string_view kind) const;
  void add_marks(const std::vector<RecordMember>& members, std::string_view kind);
  std::uint16_t kind_number(std::string_view kind);
  std::uint32_t name_number(std::string_view value);

  struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };

  const LogSource& source_;
  ScannedLog& log_;
  std::vector<const RecordKind*> record_kinds_;  // of each kind
  std::unordered_map<std::string, std::uint32_t, TextHash, std::equal_to<>> name_numbers_;
};

Outcome Scan::read_on(std::uint64_t offset) {
  std::string held;                // bytes that have been read and not yet used
  std::uint64_t held_at = offset;  // where it begins in the file
  std::size_t searched = 0;        // no line's end before this place
  for (;;) {
    const auto kept = held.size();
    held.resize(kept + block_bytes);
    const auto got = source_.read(held_at + kept, held.data() + kept, block_bytes);
    if (got < 0) return Error{log_.where(log_.entries.size()), reading_problem(got)};
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
  log_.bytes = held_at + held.size();
  if (log_.bytes == 0) return Error{log_.path, "the file is empty; expected a run log"};
  // The rest has no line's end: the writer was stopped in the middle of it. It may be a whole record all the same.
  if (!held.empty() && (!Json::accept(held) || add_line(held, held_at))) {
    if (log_.entries.empty())
      return Error{log_.path + ":1", "not a run log: the first line is not a whole record of kind 'run'"};
    log_.trouble = fmt::format("Line {} is cut short; the log is shown up to record {}.", log_.entries.size() + 1,
                               log_.entries.size() - 1);
  } else if (!log_.complete()) {
    log_.trouble =
        fmt::format("The log has no end record: the run was cut short after record {}.", log_.entries.size() - 1);
  }
  return note_last_line();
}

Outcome Scan::note_last_line() {
  const auto& last = log_.entries.back();
  std::string line(last.length, '\0');
  const auto got = source_.read(last.offset, line.data(), line.size());
  if (got != static_cast<ssize_t>(line.size())) return Error{log_.where(log_.entries.size() - 1), reading_problem(got)};
  log_.last_line = hash_of(line);
  return std::nullopt;
}

std::uint16_t Scan::kind_number(std::string_view kind) {
  const auto found = std::find_if(log_.kinds.begin(), log_.kinds.end(), [&](const std::string& known) {
    return known.size() == kind.size() && known[0] == kind[0] && known == kind;
  });
  if (found != log_.kinds.end()) return static_cast<std::uint16_t>(found - log_.kinds.begin());
  if (log_.kinds.size() >= most_kinds) return static_cast<std::uint16_t>(log_.kinds.size() - 1);
  log_.kinds.emplace_back(kind);
  record_kinds_.push_back(record_kind(kind));
  return static_cast<std::uint16_t>(log_.kinds.size() - 1);
}

// `value` as written.
std::uint32_t Scan::name_number(std::string_view value) {
  const bool plain = is_plain_text(value);
  const auto written = plain ? std::string() : text_in(value);
  const std::string_view name = plain ? value.substr(1, value.size() - 2) : std::string_view(written);
  const auto found = name_numbers_.find(name);
  if (found != name_numbers_.end()) return found->second;
  const auto number = static_cast<std::uint32_t>(log_.names.size());
  log_.names.emplace_back(name);
  name_numbers_.emplace(name, number);
  return number;
}

Outcome Scan::add_line(std::string_view line, std::uint64_t offset) {
  const auto n = log_.entries.size();
  if (n >= most_records) return Error{log_.where(n), "more records than this program reads"};
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
  entry.by_sample = entry.sample || (entry.cause >= 0 && log_.entries[static_cast<std::size_t>(entry.cause)].by_sample);
  entry.meaning = meaning_of(record_kinds_[entry.kind], members);
  log_.entries.push_back(entry);
  add_marks(members, kind);
  return std::nullopt;
}

// A sentence if these are not the members of the next record.
Outcome Scan::problem_of(const std::vector<RecordMember>& members, bool whole, std::string_view kind) const {
  const auto n = log_.entries.size();
  if (n == 0 && (!whole || !log::is<log::Run>(kind)))
    return Error{log_.where(0), "not a run log: the first line is not a whole record of kind 'run'"};
  if (n == 0 && number_in<double>(value_in(members, name_of(&log::Run::version))).value_or(0) != 1)
    return Error{log_.where(0), "a run log of another version; this program reads version 1"};
  if (!whole) return Error{log_.where(n), "not a JSON object on one line; expected a record"};
  if (kind.empty()) return Error{log_.where(n), "a record without 'kind'"};
  const auto number = number_in<std::size_t>(value_in(members, name_of(&log::Stamp::n)));
  if (!number) return Error{log_.where(n), "a record without its number 'n'"};
  if (number != n)
    return Error{log_.where(n),
                 fmt::format("record number {} where {} was expected: lines are missing or out of order", *number, n)};
  if (!number_in<double>(value_in(members, name_of(&log::Stamp::t_s))))
    return Error{log_.where(n), "a record without its time 't' in seconds"};
  return std::nullopt;
}

// Notes the values of the last record by which other parts of a log are found.
void Scan::add_marks(const std::vector<RecordMember>& members, std::string_view kind) {
  const auto n = static_cast<std::uint32_t>(log_.entries.size() - 1);
  const auto value = [&](auto member) { return value_in(members, name_of(member)); };
  // A symbol lies above an older one: a chain can only lead down, even in a broken file.
  if (log::is<log::Symbol>(kind)) {
    const auto id = number_in<std::int64_t>(value(&log::Symbol::id));
    const auto below = number_in<std::int64_t>(value(&log::Symbol::below));
    const auto* lower = below ? log_.symbol(*below) : nullptr;
    const std::array<std::uint64_t, 2> stack{lower ? lower->stack : 0, hash_of(value(&log::Symbol::slots))};
    if (id && *id >= 0)
      log_.symbols.try_emplace(*id, SymbolPlace{n, lower ? lower->depth + 1 : 1, lower ? *below : -1,
                                                hash_of({reinterpret_cast<const char*>(stack.data()), sizeof stack})});
  }
  // Kinds that change the stack name its top by the same member.
  if (const auto top_value = value(&log::Transition::stack); !top_value.empty()) {
    const auto top = number_in<std::int64_t>(top_value).value_or(-1);
    const auto* symbol_on_top = log_.symbol(top);
    const auto depth = number_in<std::uint32_t>(value(&log::Transition::depth));
    log_.marks.push_back({n, depth.value_or(symbol_on_top ? symbol_on_top->depth : 0), top});
  }
  if (log::is_any<log::Transition, log::Correction>(kind))
    log_.steps.push_back({n, name_number(value(&log::Transition::id)), name_number(value(&log::Transition::from)),
                          name_number(value(&log::Transition::to))});
  if (const auto act = number_in<std::int64_t>(value(&log::Act::act)); act && log::is<log::Act>(kind)) {
    const auto step = number_in<std::int64_t>(value(&log::Act::step)).value_or(0);
    log_.acts.push_back({n, *act, static_cast<std::uint32_t>(std::max<std::int64_t>(step, 0)),
                         text_in(value(&log::Act::status)) == log::asked});
  }
}

}  // namespace

bool ScannedLog::complete() const { return !entries.empty() && log::is<log::End>(kinds[entries.back().kind]); }

const SymbolPlace* ScannedLog::symbol(std::int64_t id) const {
  const auto found = symbols.find(id);
  return found == symbols.end() ? nullptr : &found->second;
}

std::string ScannedLog::where(std::size_t n) const { return fmt::format("{}:{}", path, n + 1); }

Outcome scan_log(const LogSource& source, std::uint64_t offset, ScannedLog& log) {
  return Scan(source, log).read_on(offset);
}

}  // namespace continua
