#include "continua/replay/trace/trace_event.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

#include "continua/replay/trace/trace_fields.h"

namespace continua {
namespace {

const std::map<std::string, std::vector<std::string>>& field_table() {
  static const std::map<std::string, std::vector<std::string>> table = {
      {"speech", {"t", "kind", "row", "happened", "text", "until", "confidence", "words", "alternatives"}},
      {"gesture",
       {"t", "kind", "row", "happened", "name", "hand", "direction", "phase", "target", "until", "confidence",
        "alternatives"}},
      {"pointing", {"t", "kind", "row", "happened", "hand", "target", "ray", "until", "confidence"}},
      {"observed", {"t", "kind", "row", "channel", "content"}},
      {"expect", {"t", "kind", "row", "state", "says", "indicated", "referents", "act", "holding", "stack_depth"}},
      {"end", {"t", "kind", "row"}},
  };
  return table;
}

void read_signal(const TraceFields& fields, InputEvent& event) {
  if (const auto happened = fields.number("happened", 0, trace_time_limit_s)) {
    const auto own = SimTime::from_seconds(*happened);
    if (own > event.t) fields.wrong("happened", "a time that is not after 't', when it became known");
    event.t = own;
  }
  if (const auto until = fields.number("until", 0, trace_time_limit_s)) {
    event.until = SimTime::from_seconds(*until);
    if (*event.until < event.t)
      fields.wrong("until",
                   fields.has("happened") ? "a time that is not before 'happened'" : "a time that is not before 't'");
  }
  const auto confidence = fields.number("confidence", 0, 1);
  event.confidence = confidence.value_or(1);
}

void read_alternatives(const TraceFields& fields, InputEvent& event) {
  fields.for_each("alternatives", [&](const TraceFields& alternative) {
    alternative.need({"text", "name"});
    auto content = alternative.has("text") ? alternative.text("text") : alternative.text("name");
    event.alternatives.push_back({std::move(content), alternative.number("confidence", 0, 1).value_or(1)});
  });
}

// An n-best list alone is as good as its best entry.
std::string best_of(const TraceFields& fields, const char* name, InputEvent& event) {
  fields.need({name, "alternatives"});
  if (fields.has(name) || event.alternatives.empty()) return fields.text(name);
  if (!fields.has("confidence")) event.confidence = event.alternatives.front().confidence;
  return event.alternatives.front().text;
}

std::string read_hand(const TraceFields& fields) { return fields.choice("hand", {"left", "right"}); }

InputEvent read_speech(const TraceFields& fields, SimTime t) {
  InputEvent event;
  event.t = t;
  event.modality = Modality::speech;
  read_signal(fields, event);
  read_alternatives(fields, event);
  event.text = best_of(fields, "text", event);
  fields.for_each("words", [&](const TraceFields& word) {
    word.need({"text"});
    word.need({"t"});
    const auto at = word.number("t", 0, trace_time_limit_s);
    event.words.push_back({word.text("text"), SimTime::from_seconds(at.value_or(0))});
  });
  return event;
}

InputEvent read_gesture(const TraceFields& fields, SimTime t) {
  InputEvent event;
  event.t = t;
  event.modality = Modality::gesture;
  read_signal(fields, event);
  read_alternatives(fields, event);
  event.name = best_of(fields, "name", event);
  event.hand = read_hand(fields);
  event.direction = fields.text("direction");
  event.phase = fields.choice("phase", {"start", "stop", "stroke"});
  event.target_W = fields.vector("target", 2, trace_coordinate_limit_m);
  return event;
}

InputEvent read_pointing(const TraceFields& fields, SimTime t) {
  InputEvent event;
  event.t = t;
  event.modality = Modality::pointing;
  read_signal(fields, event);
  event.hand = read_hand(fields);
  fields.need({"target", "ray"});
  event.target_W = fields.vector("target", 2, trace_coordinate_limit_m);
  if (const Json* ray = fields.find("ray")) {
    if (!ray->is_object()) {
      fields.wrong("ray", "an object with 'from' and 'direction'");
      return event;
    }
    fields.within("ray", [&](const TraceFields& parts) {
      parts.need({"from"});
      parts.need({"direction"});
      const auto from = parts.vector("from", 3, trace_coordinate_limit_m);
      const auto direction = parts.vector("direction", 3, trace_coordinate_limit_m);
      if (direction && direction->isZero(0)) parts.wrong("direction", "a direction that is not zero");
      if (from && direction) event.ray = Ray{*from, *direction};
    });
  }
  return event;
}

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

}  // namespace

const std::vector<std::string>& fields_of_kind(const std::string& kind) {
  static const std::vector<std::string> none;
  const auto found = field_table().find(kind);
  return found == field_table().end() ? none : found->second;
}

const std::vector<std::string>& event_kinds() {
  static const std::vector<std::string> kinds = {"speech", "gesture", "pointing", "observed", "expect", "end"};
  return kinds;
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

  if (kind == "speech")
    event.what = read_speech(fields, event.t);
  else if (kind == "gesture")
    event.what = read_gesture(fields, event.t);
  else if (kind == "pointing")
    event.what = read_pointing(fields, event.t);
  else if (kind == "observed")
    event.what = read_observed(fields);
  else if (kind == "expect")
    event.what = read_expectation(fields, json);
  else if (kind == "end")
    event.what = End{};
  else if (!kind.empty())
    notes.push_back({line, fmt::format("unknown kind {}{}: kept and passed over", in_quotes(kind),
                                       did_you_mean(kind, event_kinds()))});
  event.json = std::move(json);
  return event;
}

}  // namespace continua
