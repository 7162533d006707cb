// Writes traces: the inverse of trace_file.cpp and trace_event.cpp.
#include <algorithm>

#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {
namespace {

const std::vector<std::string>& header_fields() {
  static const std::vector<std::string> names = {"kind",        "version", "scene",    "machine",    "language", "seed",
                                                 "perspective", "source",  "recorded", "parameters", "objects"};
  return names;
}

Json pair_of(const Vec3& p_W) { return Json::array({p_W.x(), p_W.y()}); }
Json triple_of(const Vec3& p_W) { return Json::array({p_W.x(), p_W.y(), p_W.z()}); }

void put_text(Json& json, const char* name, const std::string& text) {
  if (!text.empty()) json[name] = text;
}

void put_input(Json& json, const InputEvent& event) {
  if (event.modality == Modality::speech) json["text"] = event.text;
  if (event.modality == Modality::gesture) json["name"] = event.name;
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

std::string kind_of(const TraceEvent& event) {
  if (const auto* input = std::get_if<InputEvent>(&event.what)) return text(input->modality);
  if (std::holds_alternative<Observed>(event.what)) return "observed";
  if (std::holds_alternative<Expectation>(event.what)) return "expect";
  if (std::holds_alternative<End>(event.what)) return "end";
  return event.json.is_object() ? event.json.value("kind", "") : "";
}

// Appends what `read` holds beside the fields of `known`.
void put_unknown_fields(Json& json, const Json& read, const std::vector<std::string>& known) {
  if (!read.is_object()) return;
  for (const auto& [key, value] : read.items())
    if (std::find(known.begin(), known.end(), key) == known.end() && !json.contains(key)) json[key] = value;
}

}  // namespace

Json json_of(const TraceEvent& event) {
  Json json;
  json["t"] = event.t.seconds();
  const std::string kind = kind_of(event);
  json["kind"] = kind;
  if (event.row) json["row"] = *event.row;
  if (const auto* input = std::get_if<InputEvent>(&event.what)) {
    if (input->t < event.t) json["happened"] = input->t.seconds();
    put_input(json, *input);
  }
  if (const auto* observed = std::get_if<Observed>(&event.what)) {
    json["channel"] = observed->channel;
    json["content"] = observed->content;
  }
  if (const auto* expected = std::get_if<Expectation>(&event.what)) put_expectation(json, *expected);
  put_unknown_fields(json, event.json, fields_of_kind(kind));
  return json;
}

std::string write_header(const TraceHeader& header) {
  Json json;
  json["kind"] = "trace";
  json["version"] = 1;
  if (!header.scene.empty()) json["scene"] = header.scene;
  if (!header.machine.empty()) json["machine"] = header.machine;
  if (!header.language.empty()) json["language"] = header.language;
  json["seed"] = header.seed;
  json["perspective"] = text(header.perspective);
  if (!header.source.empty()) json["source"] = header.source;
  if (!header.recorded.empty()) json["recorded"] = header.recorded;
  if (!header.parameters.empty()) json["parameters"] = header.parameters;
  for (const auto& [name, start] : header.objects) {
    if (!start.removed && !start.position_W && !start.yaw_rad) continue;
    Json place;
    if (start.position_W) place["position"] = {start.position_W->x(), start.position_W->y(), start.position_W->z()};
    if (start.yaw_rad) place["yaw"] = *start.yaw_rad;
    json["objects"][name] = start.removed ? Json() : place;
  }
  put_unknown_fields(json, header.json, header_fields());
  return compact(json);
}

std::string write_event(const TraceEvent& event) { return compact(json_of(event)); }

std::string write_trace(const Trace& trace) {
  std::string out = write_header(trace.header) + '\n';
  for (const auto& event : trace.events) out += write_event(event) + '\n';
  return out;
}

}  // namespace continua
