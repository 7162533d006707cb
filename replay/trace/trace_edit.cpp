#include "continua/replay/trace/trace_edit.h"

#include <fmt/format.h>

#include <algorithm>

#include "continua/core/digest.h"
#include "continua/replay/trace/event_shift.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_header.h"

namespace continua {
namespace {

Trace numbered(TraceHead head, std::vector<TraceEvent> events) {
  Trace trace;
  static_cast<TraceHead&>(trace) = std::move(head);
  trace.notes.clear();
  trace.events = std::move(events);
  for (std::size_t i = 0; i < trace.events.size(); ++i) trace.events[i].line = i + 2;
  trace.digest = digest(write_trace(trace));
  return trace;
}

bool is_end(const TraceEvent& event) { return std::holds_alternative<End>(event.what); }

// The first difference of two headers that keeps their events from being one trace's.
Outcome difference(const Trace& first, const Trace& other) {
  const auto &a = first.header, &b = other.header;
  const auto differ = [&](const char* what, const std::string& one, const std::string& another) -> Outcome {
    if (one == another) return std::nullopt;
    return Error{other.name, fmt::format("'{}' is {}, in {} it is {}; expected the same in all", what,
                                         in_quotes(another), first.name, in_quotes(one))};
  };
  for (const auto& [what, one, another] :
       {std::tuple("scene", a.scene, b.scene), std::tuple("machine", a.machine, b.machine),
        std::tuple("language", a.language, b.language),
        std::tuple("perspective", name_of(a.perspective), name_of(b.perspective)),
        std::tuple("seed", std::to_string(a.seed), std::to_string(b.seed)),
        std::tuple("parameters", compact(a.parameters), compact(b.parameters))})
    if (auto problem = differ(what, one, another)) return problem;
  return std::nullopt;
}

}  // namespace

Trace cut_trace(const Trace& trace, SimTime from, std::optional<SimTime> to) {
  std::vector<TraceEvent> events;
  for (const auto& event : trace.events)
    if (event.t >= from && (!to || event.t < *to)) events.push_back(event);
  return numbered(trace, std::move(events));
}

Result<Trace> merge_traces(const std::vector<Trace>& traces) {
  std::vector<TraceEvent> events, ends;
  for (const auto& trace : traces) {
    if (auto problem = difference(traces.front(), trace)) return *problem;
    for (const auto& event : trace.events) (is_end(event) ? ends : events).push_back(event);
  }
  const auto earlier = [](const TraceEvent& a, const TraceEvent& b) { return a.t < b.t; };
  std::stable_sort(events.begin(), events.end(), earlier);
  if (const auto last = std::max_element(ends.begin(), ends.end(), earlier); last != ends.end())
    if (events.empty() || last->t >= events.back().t) events.push_back(*last);
  return numbered(traces.front(), std::move(events));
}

Result<Trace> shift_trace(const Trace& trace, SimTime by) {
  return changed_trace(
      trace, [&](Json event) { return shifted_event(std::move(event), by); },
      [&](Json header) {
        if (!header.contains("media")) return header;
        for (auto& one : header["media"])
          if (const double offset_s = one.value("offset", 0.0) - by.seconds(); offset_s != 0)
            one["offset"] = offset_s;
          else
            one.erase("offset");
        return header;
      });
}

Trace select_events(const Trace& trace, const std::function<bool(const Json& event)>& wanted) {
  std::vector<TraceEvent> events;
  for (const auto& event : trace.events)
    if (wanted(json_of(event))) events.push_back(event);
  return numbered(trace, std::move(events));
}

Result<Trace> changed_trace(const Trace& trace, const std::function<Json(Json event)>& change,
                            const std::function<Json(Json header)>& change_header) {
  TraceHead head = trace;
  std::vector<Error> problems;
  if (change_header) {
    const auto line = compact(change_header(Json::parse(write_header(trace.header))));
    const auto header = header_from_line(std::string_view(line), trace.name, 1, problems);
    if (!problems.empty()) return problems.front();
    head.header = *header;
  }
  std::vector<TraceEvent> events;
  for (const auto& event : trace.events) {
    events.push_back(event_from_json(change(json_of(event)), trace.name, event.line, problems, head.notes));
    if (!problems.empty()) return problems.front();
  }
  return numbered(std::move(head), std::move(events));
}

}  // namespace continua
