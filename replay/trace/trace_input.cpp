#include "continua/replay/trace/trace_input.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

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
  if (const Json* list = fields.find("alternatives"); list && list->is_array() && list->size() > most_alternatives)
    return fields.problem(
        fmt::format("'alternatives' has {} entries; expected at most {}", list->size(), most_alternatives));
  fields.for_each("alternatives", [&](const TraceFields& alternative) {
    alternative.need({"text", "name"});
    auto content = alternative.has("text") ? alternative.text("text") : alternative.text("name");
    event.alternatives.push_back({std::move(content), alternative.number("confidence", 0, 1).value_or(1)});
  });
}

// The content of an input: its own, or the surest entry of its n-best list. That entry leaves the list, so that each
// counts once; the input is as sure as the entry unless it says so itself.
std::string best_of(const TraceFields& fields, const char* name, InputEvent& event) {
  auto& others = event.alternatives;
  const auto own = fields.has(name) ? std::optional(fields.text(name)) : std::nullopt;
  const auto best =
      own ? std::find_if(others.begin(), others.end(), [&](const auto& each) { return each.text == *own; })
          : std::max_element(others.begin(), others.end(),
                             [](const auto& a, const auto& b) { return a.confidence < b.confidence; });
  if (best == others.end()) return own.value_or("");
  const auto [content, confidence] = *best;
  if (!fields.has("confidence")) event.confidence = confidence;
  others.erase(best);
  return content;
}

std::string read_hand(const TraceFields& fields) { return fields.choice("hand", {"left", "right"}); }

Json pair_of(const Vec3& p_W) { return Json::array({p_W.x(), p_W.y()}); }
Json triple_of(const Vec3& p_W) { return Json::array({p_W.x(), p_W.y(), p_W.z()}); }

void put_text(Json& json, const char* name, const std::string& text) {
  if (!text.empty()) json[name] = text;
}

void put_input(Json& json, const InputEvent& event) {
  if (event.modality == Modality::speech) json["text"] = event.text;
  if (!event.final) json["final"] = false;
  if (event.modality == Modality::gesture && !event.name.empty()) json["name"] = event.name;
  put_text(json, "hand", event.hand);
  put_text(json, "direction", event.direction);
  put_text(json, "phase", event.phase);
  if (event.target_W) json["target"] = pair_of(*event.target_W);
  if (event.ray) {
    json["ray"]["from"] = triple_of(event.ray->from_W);
    json["ray"]["direction"] = triple_of(event.ray->direction_W);
  }
  if (event.until) json["until"] = event.until->seconds();
  if (event.confidence != 1) json["confidence"] = event.confidence;
  if (!event.features.empty()) json["features"] = event.features.numbers();
  for (const auto& word : event.words) {
    Json entry;
    entry["text"] = word.text;
    entry["t"] = word.t.seconds();
    json["words"].push_back(std::move(entry));
  }
  for (const auto& alternative : event.alternatives) {
    Json entry;
    entry["text"] = alternative.text;
    entry["confidence"] = alternative.confidence;
    json["alternatives"].push_back(std::move(entry));
  }
}

}  // namespace

InputEvent read_speech(const TraceFields& fields, SimTime t) {
  InputEvent event;
  event.t = t;
  event.modality = Modality::speech;
  read_signal(fields, event);
  read_alternatives(fields, event);
  fields.need({"text", "alternatives"});
  event.text = best_of(fields, "text", event);
  event.final = fields.truth("final", true);
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
  fields.need({"name", "alternatives", "features"});
  event.name = best_of(fields, "name", event);
  event.features = Shape(fields.numbers("features"));
  event.hand = read_hand(fields);
  event.direction = fields.text("direction");
  event.phase = fields.choice("phase", {"start", "stop", "stroke"});
  event.target_W = fields.vector("target", 2, trace_coordinate_limit_m);
  return event;
}

namespace {

// The place that a hand or the eyes are directed at.
void read_direction(const TraceFields& fields, InputEvent& event) {
  fields.need({"target", "ray"});
  event.target_W = fields.vector("target", 2, trace_coordinate_limit_m);
  if (const Json* ray = fields.find("ray")) {
    if (!ray->is_object()) {
      fields.wrong("ray", "an object with 'from' and 'direction'");
      return;
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
}

}  // namespace

InputEvent read_pointing(const TraceFields& fields, SimTime t) {
  InputEvent event;
  event.t = t;
  event.modality = Modality::pointing;
  read_signal(fields, event);
  event.hand = read_hand(fields);
  read_direction(fields, event);
  return event;
}

InputEvent read_gaze(const TraceFields& fields, SimTime t) {
  InputEvent event;
  event.t = t;
  event.modality = Modality::gaze;
  read_signal(fields, event);
  read_direction(fields, event);
  return event;
}

void put_input_event(Json& json, const TraceEvent& event) {
  const auto& input = std::get<InputEvent>(event.what);
  if (input.t < event.t) json["happened"] = input.t.seconds();
  put_input(json, input);
}

}  // namespace continua
