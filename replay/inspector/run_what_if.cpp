#include "continua/replay/inspector/run_what_if.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

constexpr std::size_t most_blank_lines = 100000;  // that are left where a log tells nothing of its trace's lines

// An event of a trace that is to be.
struct Line {
  std::size_t line = 0;  // 0: not known
  std::size_t n = 0;
  double t = 0;
  std::string text;
};

bool is_instant(const Json& t) { return t.is_number() && t.get<double>() >= 0 && t.get<double>() <= latest_s; }

Outcome read_edits(const Json& edits, WhatIfRequest& request) {
  if (!edits.is_array()) return Error{"", R"('edits' must be a list of {"n", "event"})"};
  for (const auto& edit : edits) {
    const auto& n = member_of(edit, "n");
    if (!n.is_number_unsigned() || !edit.contains("event") || !(edit["event"].is_object() || edit["event"].is_null()))
      return Error{
          "", fmt::format(R"(edit {}: expected {{"n": RECORD, "event": {{…}} or null}})", request.edits.size() + 1)};
    request.edits.push_back({n.get<std::size_t>(), edit["event"]});
    const auto& t = member_of(edit, "t");
    if (t.is_null()) continue;
    if (!is_instant(t))
      return Error{"", fmt::format("edit {}: 't' is {}; expected seconds from 0", request.edits.size(), compact(t))};
    request.edits.back().t = t.get<double>();
  }
  return std::nullopt;
}

Outcome read_forced(const Json& force, WhatIfRequest& request) {
  if (!force.is_object()) return Error{"", R"('force' must be {"STEP": "TRANSITION"})"};
  for (const auto& [step, transition] : force.items()) {
    const auto number = number_in<int>(step);
    if (!number || *number < 1)
      return Error{"", fmt::format("'force': {} is no step, a number from 1", in_quotes(step))};
    if (!transition.is_string())
      return Error{"",
                   fmt::format("'force': step {}: found {}; expected a transition's id", step, compact(transition))};
    request.forced[*number] = transition.get<std::string>();
  }
  return std::nullopt;
}

// The event as a line of a trace.
std::string line_of(const Json& event, double t) {
  Json line{{"t", t}};
  for (const auto& [key, value] : event.items())
    if (key != "t") line.get_ref<Json::object_t&>().emplace_back(key, value);
  return compact(line);
}

bool tells_event(const std::string& kind) {
  const auto* schema = log::schema_of(kind);
  return log::is<log::Input>(kind) || log::is<log::Expect>(kind) || (schema && schema->kind.repeats_event);
}

// The event of the trace that a record was of; null if it was none.
Json event_of(const std::string& kind, const Json& record) {
  if (log::is<log::Input>(kind)) {
    const auto& event = member_of(record, "event");
    return event.is_object() && text_of(event, "kind") != "act" ? event : Json();
  }
  Json event{{"kind", kind}};
  if (!log::is<log::Expect>(kind)) {
    event.update(log::members_of(log::readable_part(record)));
    event.erase("line");
  } else if (const auto& expected = member_of(record, "expected"); expected.is_object()) {
    event.update(expected);
  } else {
    return {};
  }
  return event;
}

// Whether the lines, put in order of their numbers, can stand on them in a file.
bool keep_places(std::vector<Line>& lines) {
  auto placed = lines;
  std::stable_sort(placed.begin(), placed.end(), [](const Line& a, const Line& b) { return a.line < b.line; });
  std::size_t last = 1;
  double t = 0;
  for (const auto& line : placed) {
    if (line.line <= last || line.t < t) return false;
    last = line.line;
    t = line.t;
  }
  if (last > lines.size() + most_blank_lines) return false;
  lines = std::move(placed);
  return true;
}

Outcome check_edit(const InputEdit& edit, const RunIndex& run, const WhatIfRequest& request) {
  const auto no_input = Error{"", fmt::format("n={} is no input of the trace", edit.n)};
  if (edit.n >= run.size()) return Error{"", fmt::format("n={}: the run has records 0 to {}", edit.n, run.size() - 1)};
  if (!log::is<log::Input>(run.kind(edit.n))) return no_input;
  const auto record = run.record(edit.n);
  if (!record) return record.error();
  if (event_of("input", *record).is_null()) return no_input;
  if (edit.event.is_object() && edit.event.contains("t"))
    return Error{"", fmt::format("n={}: found 't'; expected an event without it: an edit's own 't' moves it", edit.n)};
  const auto was = run.entry(edit.n).t.seconds(), t = std::min(was, edit.t.value_or(was));
  if (request.from && t < *request.from)
    return Error{"", fmt::format("n={} is at {} s; expected an input from {} s on", edit.n, t, *request.from)};
  return std::nullopt;
}

}  // namespace

Result<WhatIfRequest> what_if_request(const Json& json) {
  if (!json.is_object()) return Error{"", "expected an object"};
  static const std::set<std::string> known{"run", "from", "edits", "force", "seed", "choice"};
  for (const auto& [key, value] : json.items())
    if (!known.count(key)) return Error{"", fmt::format("{} is nothing that can be asked for", in_quotes(key))};
  WhatIfRequest request;
  if (!member_of(json, "run").is_string()) return Error{"", "'run' is missing: the id of a run"};
  request.run = json["run"].get<std::string>();
  if (const auto& from = member_of(json, "from"); !from.is_null()) {
    if (!is_instant(from)) return Error{"", fmt::format("'from' is {}; expected seconds from 0", compact(from))};
    request.from = from.get<double>();
  }
  if (const auto& edits = member_of(json, "edits"); !edits.is_null())
    if (auto wrong = read_edits(edits, request)) return *wrong;
  if (const auto& force = member_of(json, "force"); !force.is_null())
    if (auto wrong = read_forced(force, request)) return *wrong;
  if (const auto& seed = member_of(json, "seed"); !seed.is_null()) {
    if (!seed.is_number_unsigned())
      return Error{"", fmt::format("'seed' is {}; expected a number from 0", compact(seed))};
    request.seed = seed.get<std::uint64_t>();
  }
  if (const auto& choice = member_of(json, "choice"); !choice.is_null()) {
    if (!choice.is_string()) return Error{"", fmt::format("'choice' is {}; expected a name", compact(choice))};
    request.choice = choice.get<std::string>();
  }
  return request;
}

Result<std::string> trace_lines(const RunIndex& run, const WhatIfRequest& request) {
  std::map<std::size_t, const InputEdit*> edited;
  for (const auto& edit : request.edits) {
    if (auto wrong = check_edit(edit, run, request)) return *wrong;
    if (!edited.emplace(edit.n, &edit).second) return Error{"", fmt::format("n={} is edited twice", edit.n)};
  }
  std::vector<Line> lines;
  for (std::size_t n = 0; n < run.size(); ++n) {
    const auto& kind = run.kind(n);
    if (!tells_event(kind)) continue;
    const auto record = run.record(n);
    if (!record) return record.error();
    auto event = event_of(kind, *record);
    auto t = run.entry(n).t.seconds();
    if (const auto edit = edited.find(n); edit != edited.end()) {
      event = edit->second->event;
      t = edit->second->t.value_or(t);
    }
    if (event.is_null()) continue;
    const auto& line = member_of(*record, "line");
    lines.push_back({line.is_number_unsigned() ? line.get<std::size_t>() : 0, n, t, line_of(event, t)});
  }
  const bool placed = keep_places(lines);
  if (!placed) std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.t < b.t; });
  std::string text;
  std::size_t next = 2;
  for (const auto& line : lines) {
    for (; placed && next < line.line; ++next) text += '\n';
    text += line.text + '\n';
    ++next;
  }
  // So that it is watched as long.
  if (run.complete()) text += line_of({{"kind", "end"}}, run.entry(run.size() - 1).t.seconds()) + '\n';
  return text;
}

}  // namespace continua
