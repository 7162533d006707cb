#include "continua/replay/live/live_events.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

// An event may be so far ahead of the clock, seconds: of the wall's clock by the difference of two clocks, else by a
// long silence.
constexpr double most_ahead_s = 1, most_silence_s = 86400;

// Time goes on to its `t`; an event of live sessions alone.
bool is_clock(const Json& event) {
  const auto kind = event.find("kind");
  return kind != event.end() && *kind == "clock";
}

// The event's own time, if it tells one that is a time; else the trace's reader has something to say.
std::optional<SimTime> own_time(const Json& event) {
  if (!has_time(event) || !event["t"].is_number()) return std::nullopt;
  const auto t_s = event["t"].get<double>();
  if (!(t_s >= 0 && t_s <= trace_time_limit_s)) return std::nullopt;
  return SimTime::from_seconds(t_s);
}

Error ahead(const std::string& where, SimTime t, SimTime now, LiveTiming timing) {
  const bool wall = timing == LiveTiming::wall;
  return {where, fmt::format("'t' is {}, {} s ahead of the session's time; expected at most {} s{}", t.seconds(),
                             (t - now).seconds(), wall ? most_ahead_s : most_silence_s,
                             wall ? ", or a session whose clock goes by events" : "")};
}

// The event as it will be read from line `line` of the trace. The client's text stays as it is, apart from the time.
Result<LiveEvent> read_event_at(const Json& json, SimTime t, std::optional<SimTime> own, std::size_t line,
                                const std::string& where) {
  Json timed;
  if (json.is_object() && (!has_time(json) || own)) {
    timed["t"] = own == t ? json["t"] : Json(t.seconds());
    if (own && *own < t) timed["happened"] = own->seconds();
    for (const auto& [key, value] : json.items())
      if (key != "t" && key != "happened") timed[key] = value;
  } else {
    timed = json;  // the reader tells its fault
  }
  LiveEvent event{t, {}, compact(timed)};
  std::vector<Error> problems;
  std::vector<Note> notes;
  event.event = event_from_json(std::move(timed), where, line, problems, notes);
  if (!problems.empty()) return Error{where, problems.front().sentence};
  if (std::holds_alternative<UnknownKind>(event.event->what)) {
    const std::string kind = event.event->json["kind"];
    return Error{where, fmt::format("unknown kind {}{}; expected {} or clock", in_quotes(kind),
                                    did_you_mean(kind, event_kinds()), fmt::join(event_kinds(), ", "))};
  }
  return event;
}

}  // namespace

bool has_time(const Json& event) { return event.is_object() && event.contains("t"); }

Result<std::vector<Json>> events_in(std::string_view body) {
  std::vector<Json> events;
  auto whole = parse_json_line(body, "body", 1);
  const bool named = whole && whole->is_object() && !whole->contains("kind") && whole->contains("events");
  if (named) whole = Json((*whole)["events"]);
  if (whole && whole->is_array()) {
    for (auto& event : *whole) events.push_back(std::move(event));
  } else if (whole) {
    events.push_back(*std::move(whole));
  } else if (const auto last = body.find_last_not_of(" \t\r\n");
             last == std::string_view::npos || body.find('\n') >= last) {
    return whole.error();
  } else {
    for (std::size_t line = 1; !body.empty(); ++line) {
      const auto length = std::min(body.find('\n'), body.size());
      const auto text = body.substr(0, length);
      body.remove_prefix(std::min(length + 1, body.size()));
      if (text.find_first_not_of(" \t\r") == std::string_view::npos) continue;
      auto event = parse_json_line(text, "body", line);
      if (!event) return event.error();
      events.push_back(*std::move(event));
    }
  }
  if (events.empty()) return Error{"body", "found no event; expected at least one"};
  return events;
}

Result<std::vector<LiveEvent>> timed_events(const std::vector<Json>& events, LiveTiming timing, SimTime now,
                                            std::size_t next_line) {
  std::vector<LiveEvent> timed;
  const auto most = SimTime::from_seconds(timing == LiveTiming::wall ? most_ahead_s : most_silence_s);
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto where = events.size() == 1 ? std::string("event") : fmt::format("event {}", i + 1);
    if (!timed.empty() && timed.back().event && std::holds_alternative<End>(timed.back().event->what))
      return Error{where, "found after 'end'; expected 'end' to be the last"};
    const auto own = own_time(events[i]);
    if (own && *own > now + most) return ahead(where, *own, now, timing);
    now = std::max(now, own.value_or(now));
    if (events[i].is_object() && is_clock(events[i])) {
      if (!own) return Error{where, "clock has no time 't'; expected that to which time goes on"};
      timed.push_back({now, {}, ""});
      continue;
    }
    auto event = read_event_at(events[i], now, own, next_line, where);
    if (!event) return event.error();
    ++next_line;
    timed.push_back(*std::move(event));
  }
  return timed;
}

}  // namespace continua
