#include "continua/replay/experiment/trace_diff.h"

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/replay/diff/run_diff_words.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_meaning.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

// The event as a record of a run has it, for words.
Json record_of(const Trace& trace, std::optional<std::size_t> event) {
  return event ? json_of(trace.events[*event]) : Json();
}

std::vector<EventSeen> events_of(const Trace& trace) {
  std::vector<EventSeen> events;
  for (const auto& event : trace.events) {
    const auto json = json_of(event);
    events.push_back({meaning_of_event(compact(json)), hash_of(text_of(json, "kind")), event.t});
  }
  return events;
}

std::string told_header(const GivenDifference& one) {
  const auto value = [](const Json& json) { return json.is_null() ? std::string("nothing") : compact(json); };
  return fmt::format("{}: {} in A, {} in B", one.what, value(one.a), value(one.b));
}

std::size_t line_of(const Trace& trace, std::optional<std::size_t> event) {
  return event ? trace.events[*event].line : 0;
}

}  // namespace

TraceDiff diff_traces(const Trace& a, const Trace& b) {
  TraceDiff diff;
  diff.header = document_differences("header", parse_json_line(write_header(a.header), a.name, 1).value(),
                                     parse_json_line(write_header(b.header), b.name, 1).value());
  const auto aligned = align_events(events_of(a), events_of(b));
  for (const auto& change : aligned.changes) {
    const auto other = change.other ? record_of(a, change.other->first) : Json();
    diff.changes.push_back(
        {change.kind, line_of(a, change.a), line_of(b, change.b),
         change_in_words(RunWords(""), change.kind, record_of(a, change.a), record_of(b, change.b), other)});
  }
  diff.same = diff.header.empty() && diff.changes.empty();
  const auto count = diff.header.size() + diff.changes.size();
  if (diff.same) {
    diff.sentence = "The traces are the same.";
  } else {
    diff.sentence = diff.header.empty() ? diff.changes.front().cause.sentence : told_header(diff.header.front());
    diff.sentence += count == 1 ? "." : fmt::format("; {} more change{}.", count - 1, count == 2 ? "" : "s");
  }
  return diff;
}

std::string trace_diff_text(const TraceDiff& diff, bool colour) {
  const auto painted = [&](const char* code, const std::string& line) {
    return colour ? fmt::format("\x1b[{}m{}\x1b[0m\n", code, line) : line + "\n";
  };
  auto text = painted("1", diff.sentence);
  if (diff.same) return text;
  text += "\n";
  for (const auto& one : diff.header) text += painted("33", "  ~ header: " + told_header(one));
  for (const auto& change : diff.changes) {
    const bool only_a = change.kind == EventChange::Kind::dropped, only_b = change.kind == EventChange::Kind::added;
    std::string lines;
    if (change.line_a) lines += fmt::format("A line {}", change.line_a);
    if (change.line_b) lines += fmt::format("{}B line {}", lines.empty() ? "" : ", ", change.line_b);
    text += painted(only_a   ? "31"
                    : only_b ? "32"
                             : "33",
                    fmt::format("  {} {} ({}): {}",
                                only_a   ? "-"
                                : only_b ? "+"
                                         : "~",
                                name_of(change.kind), lines, change.cause.sentence));
  }
  return text;
}

std::string trace_diff_markdown(const TraceDiff& diff) {
  std::string text = fmt::format("**{}**\n", diff.sentence);
  for (const auto& one : diff.header) text += fmt::format("\n- header: {}", told_header(one));
  for (const auto& change : diff.changes)
    text += fmt::format("\n- {}: {}", name_of(change.kind), change.cause.sentence);
  return diff.same ? text : text + "\n";
}

Json trace_diff_json(const TraceDiff& diff) {
  Json header = Json::array(), changes = Json::array();
  for (const auto& one : diff.header) header.push_back({{"what", one.what}, {"a", one.a}, {"b", one.b}});
  for (const auto& change : diff.changes)
    changes.push_back({{"kind", name_of(change.kind)},
                       {"line_a", change.line_a ? Json(change.line_a) : Json(nullptr)},
                       {"line_b", change.line_b ? Json(change.line_b) : Json(nullptr)},
                       {"what", change.cause.what},
                       {"a", change.cause.a},
                       {"b", change.cause.b},
                       {"sentence", change.cause.sentence}});
  return {
      {"same", diff.same}, {"sentence", diff.sentence}, {"header", std::move(header)}, {"changes", std::move(changes)}};
}

}  // namespace continua
