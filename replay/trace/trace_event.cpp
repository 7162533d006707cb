#include "continua/replay/trace/trace_event.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

#include "continua/replay/trace/trace_fields.h"
#include "continua/replay/trace/trace_input.h"

namespace continua {
namespace {

Observed read_observed(const TraceFields& fields) {
  fields.need({"channel"});
  fields.need({"content"});
  return {fields.choice("channel", {"speech", "gesture", "action"}), fields.text("content")};
}

Expectation read_expectation(const TraceFields& fields, const Json& json) {
  Expectation expected;
  const auto text = [&](const char* name, std::optional<std::string>& into) {
    const Json* value = fields.find(name);
    if (value) into = value->is_null() ? "null" : fields.text(name);
  };
  text("state", expected.state);
  text("says", expected.says);
  text("indicated", expected.indicated);
  text("act", expected.act);
  text("holding", expected.holding);
  if (const Json* value = fields.find("referents")) {
    const bool texts = value->is_array() &&
                       std::all_of(value->begin(), value->end(), [](const Json& name) { return name.is_string(); });
    if (texts)
      expected.referents = value->get<std::vector<std::string>>();
    else
      fields.wrong("referents", "an array of texts");
  }
  if (const auto depth = fields.whole_number("stack_depth", 1'000'000))
    expected.stack_depth = static_cast<std::int64_t>(*depth);
  // A misspelt field would never be checked and would look as though it were met.
  const auto& known = fields_of_kind("expect");
  for (const auto& [key, value] : json.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      if (const auto hint = did_you_mean(key, known); !hint.empty())
        fields.problem(fmt::format("expect has an unknown field {}{}", in_quotes(key), hint));
  return expected;
}

void put_expectation(Json& json, const Expectation& expected) {
  const auto put = [&](const char* name, const std::optional<std::string>& value) {
    if (value) json[name] = *value == "null" ? Json() : Json(*value);
  };
  put("state", expected.state);
  put("says", expected.says);
  put("indicated", expected.indicated);
  if (expected.referents) json["referents"] = *expected.referents;
  put("act", expected.act);
  put("holding", expected.holding);
  if (expected.stack_depth) json["stack_depth"] = *expected.stack_depth;
}

void put_observed(Json& json, const TraceEvent& event) {
  const auto& observed = std::get<Observed>(event.what);
  json["channel"] = observed.channel;
  json["content"] = observed.content;
}

using What = decltype(TraceEvent::what);

// A kind of event, both ways. Every kind has the fields `t`, `kind` and `row` besides its own.
struct EventKind {
  std::string name;
  std::vector<std::string> fields;  // its own, in the order in which they are written
  What (*read)(const TraceFields&, SimTime t, const Json&);
  void (*write)(Json&, const TraceEvent&);  // of an event that was read by it
};

const std::vector<EventKind>& kinds() {
  using Fields = TraceFields;
  static const std::vector<EventKind> table = {
      {"speech",
       {"happened", "text", "final", "until", "confidence", "words", "alternatives"},
       [](const Fields& fields, SimTime t, const Json&) -> What { return read_speech(fields, t); },
       put_input_event},
      {"gesture",
       {"happened", "name", "hand", "direction", "phase", "target", "until", "confidence", "features", "alternatives"},
       [](const Fields& fields, SimTime t, const Json&) -> What { return read_gesture(fields, t); },
       put_input_event},
      {"pointing",
       {"happened", "hand", "target", "ray", "until", "confidence"},
       [](const Fields& fields, SimTime t, const Json&) -> What { return read_pointing(fields, t); },
       put_input_event},
      {"gaze",
       {"happened", "target", "ray", "until", "confidence"},
       [](const Fields& fields, SimTime t, const Json&) -> What { return read_gaze(fields, t); },
       put_input_event},
      {"observed",
       {"channel", "content"},
       [](const Fields& fields, SimTime, const Json&) -> What { return read_observed(fields); },
       put_observed},
      {"expect",
       {"state", "says", "indicated", "referents", "act", "holding", "stack_depth"},
       [](const Fields& fields, SimTime, const Json& json) -> What { return read_expectation(fields, json); },
       [](Json& json, const TraceEvent& event) { put_expectation(json, std::get<Expectation>(event.what)); }},
      {"mark",
       {"text"},
       [](const Fields& fields, SimTime, const Json&) -> What {
         fields.need({"text"});
         return Mark{fields.text("text")};
       },
       [](Json& json, const TraceEvent& event) { json["text"] = std::get<Mark>(event.what).text; }},
      {"end", {}, [](const Fields&, SimTime, const Json&) -> What { return End{}; }, [](Json&, const TraceEvent&) {}},
  };
  return table;
}

const EventKind* kind_named(std::string_view name) {
  const auto found =
      std::find_if(kinds().begin(), kinds().end(), [&](const EventKind& kind) { return kind.name == name; });
  return found == kinds().end() ? nullptr : &*found;
}

// The name of its kind: a modality's, or that of the alternative of TraceEvent::what.
std::string name_of_kind(const TraceEvent& event) {
  if (const auto* input = std::get_if<InputEvent>(&event.what)) return name_of(input->modality);
  if (std::holds_alternative<UnknownKind>(event.what))
    return event.json.is_object() ? event.json.value("kind", "") : std::string();
  return std::visit(
      []<class T>(const T&) -> std::string {
        if constexpr (requires { T::kind; }) return T::kind;
        return {};
      },
      event.what);
}

}  // namespace

const std::vector<std::string>& fields_of_kind(const std::string& kind) {
  static const std::vector<std::string> none;
  static const auto fields = [] {
    std::map<std::string, std::vector<std::string>> all;
    for (const auto& each : kinds()) {
      auto& names = all[each.name] = {"t", "kind", "row"};
      names.insert(names.end(), each.fields.begin(), each.fields.end());
    }
    return all;
  }();
  const auto found = fields.find(kind);
  return found == fields.end() ? none : found->second;
}

const std::vector<std::string>& event_kinds() {
  static const auto names = [] {
    std::vector<std::string> all;
    for (const auto& each : kinds()) all.push_back(each.name);
    return all;
  }();
  return names;
}

// Appends the members of `read` that are not in `known`.
void put_unknown_fields(Json& json, const Json& read, const std::vector<std::string>& known) {
  if (!read.is_object()) return;
  for (const auto& [key, value] : read.items())
    if (std::find(known.begin(), known.end(), key) == known.end() && !json.contains(key)) json[key] = value;
}

Json json_of(const TraceEvent& event) {
  Json json;
  json["t"] = event.t.seconds();
  const auto kind = name_of_kind(event);
  json["kind"] = kind;
  if (event.row) json["row"] = *event.row;
  const auto* known = kind_named(kind);
  if (known && !std::holds_alternative<UnknownKind>(event.what)) known->write(json, event);
  put_unknown_fields(json, event.json, fields_of_kind(kind));
  return json;
}

TraceEvent event_from_json(Json json, const std::string& name, std::size_t line, std::vector<Error>& problems,
                           std::vector<Note>& notes) {
  TraceEvent event;
  event.line = line;
  event.what = UnknownKind{};
  const std::string where = fmt::format("{}:{}", name, line);
  if (!json.is_object()) {
    problems.push_back({where, fmt::format("found {}; expected an event as a JSON object", in_quotes(compact(json)))});
    return event;
  }
  const auto found = json.find("kind");
  const std::string kind = found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  const TraceFields fields(json, where, kind.empty() ? "the event" : kind, problems);
  fields.need({"kind"});
  if (found != json.end() && !found->is_string()) fields.wrong("kind", "a text");
  fields.need({"t"});
  event.t = SimTime::from_seconds(fields.number("t", 0, trace_time_limit_s).value_or(0));
  if (const auto row = fields.whole_number("row", 1'000'000'000)) event.row = *row;

  if (const auto* known = kind_named(kind))
    event.what = known->read(fields, event.t, json);
  else if (!kind.empty())
    notes.push_back({line, fmt::format("unknown kind {}{}: kept and passed over", in_quotes(kind),
                                       did_you_mean(kind, event_kinds()))});
  event.json = std::move(json);
  return event;
}

}  // namespace continua
