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

}  // namespace

std::string write_header(const TraceHeader& header) {
  Json json;
  json["kind"] = "trace";
  json["version"] = 1;
  if (!header.scene.empty()) json["scene"] = header.scene;
  if (!header.machine.empty()) json["machine"] = header.machine;
  if (!header.language.empty()) json["language"] = header.language;
  json["seed"] = header.seed;
  json["perspective"] = name_of(header.perspective);
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
