#include "continua/replay/trace/trace_header.h"

#include <fmt/format.h>

#include "continua/core/local_time.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_fields.h"

namespace continua {
namespace {

constexpr const char* first_line_wanted =
    R"(expected the first line of a trace, {"kind":"trace","version":1,"scene":…,"machine":…})";

// Bodies start near the table; a coordinate beyond this is a mistake that no simulator survives.
constexpr double body_coordinate_limit_m = 1000;

ObjectStart read_object_start(const Json& json, const std::string& name, const TraceFields& objects,
                              const std::string& where, std::vector<Error>& problems) {
  ObjectStart start;
  if (json.is_null()) {
    start.removed = true;
  } else if (!json.is_object()) {
    objects.wrong(name.c_str(), R"(an object {"position":[x,y,z],"yaw":0} or null)");
  } else {
    const TraceFields fields(json, where, "object " + in_quotes(name), problems);
    fields.need({"position", "yaw"});
    start.position_W = fields.vector("position", 3, body_coordinate_limit_m);
    start.yaw_rad = fields.number("yaw", -1000, 1000);
  }
  return start;
}

TraceHeader read_header(Json json, const std::string& where, std::vector<Error>& problems) {
  TraceHeader header;
  const TraceFields fields(json, where, "the trace", problems);
  header.scene = fields.text("scene");
  header.machine = fields.text("machine");
  header.language = fields.text("language");
  header.recorded = fields.text("recorded");
  if (!header.recorded.empty() && !is_local_time(header.recorded)) fields.wrong("recorded", local_time_wanted);
  header.source = fields.text("source");
  if (const Json* parameters = fields.find("parameters")) {
    if (parameters->is_object())
      header.parameters = *parameters;
    else
      fields.wrong("parameters", "an object {NAME: value} of the machine's parameters");
  }
  fields.for_each("media", [](const TraceFields& media) {
    media.need({"file"});
    for (const char* text : {"file", "kind", "label"}) media.text(text);
    media.number("offset", -trace_time_limit_s, trace_time_limit_s);
  });
  header.seed = fields.whole_number("seed", UINT64_MAX).value_or(0);
  if (fields.choice("perspective", {"human", "avatar"}) == "avatar") header.perspective = Perspective::avatar;
  if (const Json* objects = fields.find("objects")) {
    if (!objects->is_object())
      fields.wrong("objects", R"(an object {NAME: {"position":[x,y,z],"yaw":0}})");
    else {
      const TraceFields members(*objects, where, "'objects'", problems);
      for (const auto& [name, json_of_start] : objects->items())
        header.objects.emplace_back(name, read_object_start(json_of_start, name, members, where, problems));
    }
  }
  header.json = std::move(json);
  return header;
}

// Whether `json` is the first line of a trace of our version; if not, says so.
bool is_trace_header(const Json& json, const std::string& where, std::vector<Error>& problems) {
  const auto refuse = [&](const std::string& found) {
    problems.push_back({where, fmt::format("{}; {}", found, first_line_wanted)});
    return false;
  };
  if (!json.is_object()) return refuse("found " + in_quotes(compact(json)));
  const auto kind = json.find("kind");
  if (kind == json.end()) return refuse("found an object without 'kind'");
  if (*kind != "trace")
    return refuse("found kind " + in_quotes(kind->is_string() ? kind->get<std::string>() : compact(*kind)));
  const auto version = json.find("version");
  if (version == json.end()) return refuse("found a trace without 'version'");
  if (*version == 1) return true;
  problems.push_back({where, fmt::format("found version {} of the trace format; expected 1", compact(*version))});
  return false;
}

}  // namespace

std::optional<TraceHeader> header_from_line(const std::optional<std::string_view>& text, const std::string& name,
                                            std::size_t line, std::vector<Error>& problems) {
  const auto where = fmt::format("{}:{}", name, line);
  if (!text) {
    problems.push_back({where, fmt::format("the file is empty; {}", first_line_wanted)});
    return std::nullopt;
  }
  if (text->find('\0') != std::string_view::npos) {
    problems.push_back({where, fmt::format("found binary data; {}", first_line_wanted)});
    return std::nullopt;
  }
  auto json = parse_json_line(*text, name, line);
  if (!json) {
    problems.push_back({json.error().where, fmt::format("{}; {}", json.error().sentence, first_line_wanted)});
    return std::nullopt;
  }
  if (!is_trace_header(*json, where, problems)) return std::nullopt;
  return read_header(std::move(json).value(), where, problems);
}

}  // namespace continua
