#include "continua/replay/trace/trace_file.h"

#include <fmt/format.h>
#include <algorithm>

#include "continua/core/digest.h"
#include "continua/core/local_time.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_fields.h"

namespace continua {
namespace {

constexpr const char* first_line_wanted =
    R"(expected the first line of a trace, {"kind":"trace","version":1,"scene":…,"machine":…})";

// Bodies start near the table; a coordinate beyond this is a mistake that no simulator survives.
constexpr double body_coordinate_limit_m = 1000;

struct Line {
  std::string_view text;  // without \n or \r\n
  std::size_t number;
  bool ends;  // with a newline
};

// Hands out the lines that are not blank.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  std::optional<Line> next() {
    while (!rest_.empty()) {
      const auto newline = rest_.find('\n');
      Line line{rest_.substr(0, newline), ++number_, newline != std::string_view::npos};
      rest_.remove_prefix(line.ends ? newline + 1 : rest_.size());
      if (!line.text.empty() && line.text.back() == '\r') line.text.remove_suffix(1);
      if (line.text.find_first_not_of(" \t") != std::string_view::npos) return line;
    }
    return std::nullopt;
  }

  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

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

// Reads the first line into `trace`. Without it the rest has no meaning.
bool read_first_line(const std::optional<Line>& line, Trace& trace, std::vector<Error>& problems) {
  if (!line) {
    problems.push_back({trace.name + ":1", fmt::format("the file is empty; {}", first_line_wanted)});
    return false;
  }
  if (line->text.find('\0') != std::string_view::npos) {
    problems.push_back(
        {fmt::format("{}:{}", trace.name, line->number), fmt::format("found binary data; {}", first_line_wanted)});
    return false;
  }
  auto json = parse_json_line(line->text, trace.name, line->number);
  if (!json) {
    problems.push_back({json.error().where, fmt::format("{}; {}", json.error().sentence, first_line_wanted)});
    return false;
  }
  const auto where = fmt::format("{}:{}", trace.name, line->number);
  if (!is_trace_header(*json, where, problems)) return false;
  trace.header = read_header(std::move(json).value(), where, problems);
  return true;
}

// Finds errors of an event's place among those before it.
void check_order(const Trace& trace, const TraceEvent& event, std::vector<Error>& problems) {
  if (trace.events.empty()) return;
  const auto& last = trace.events.back();
  const auto refuse = [&](std::string sentence) {
    problems.push_back({fmt::format("{}:{}", trace.name, event.line), std::move(sentence)});
  };
  if (event.t < last.t)
    refuse(fmt::format("'t' is {}, before the {} of line {}; expected events in order of time", event.t.seconds(),
                       last.t.seconds(), last.line));
  if (std::holds_alternative<End>(last.what)) refuse("found an event after 'end'; expected 'end' to be the last");
}

}  // namespace

TraceReading read_whole_trace(std::string_view text, const std::string& name) {
  TraceReading reading;
  auto& [trace, problems] = reading;
  trace.name = name;
  trace.digest = digest(text);
  Lines lines(without_byte_order_mark(text));
  if (!read_first_line(lines.next(), trace, problems)) return reading;
  while (const auto line = lines.next()) {
    auto json = parse_json_line(line->text, name, line->number);
    if (!json) {
      // A replay of part of a file would look like one of the whole: a person must judge the loss.
      if (lines.at_end() && !line->ends)
        problems.push_back({fmt::format("{}:{}", name, line->number),
                            fmt::format("the file is cut short: found {}; expected a whole line, as the {} before it",
                                        in_quotes(line->text), line->number - 1)});
      else
        problems.push_back(json.error());
      continue;
    }
    const auto before = problems.size();
    auto event = event_from_json(std::move(json).value(), name, line->number, problems, trace.notes);
    if (problems.size() == before) check_order(trace, event, problems);
    if (problems.size() == before) trace.events.push_back(std::move(event));
  }
  return reading;
}

Result<Trace> read_trace_text(std::string_view text, const std::string& name) {
  auto reading = read_whole_trace(text, name);
  if (!reading.problems.empty()) return std::move(reading.problems.front());
  return std::move(reading.trace);
}

Result<Trace> read_trace(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  return read_trace_text(*text, path);
}

Result<TraceEvent> read_event(const Json& json, const std::string& name, std::size_t line) {
  std::vector<Error> problems;
  std::vector<Note> notes;
  auto event = event_from_json(json, name, line, problems, notes);
  if (!problems.empty()) return problems.front();
  return event;
}

std::string name_of(Perspective perspective) { return perspective == Perspective::human ? "human" : "avatar"; }

std::string sentence_of(const Trace& trace, const Note& note) {
  return fmt::format("{}:{}: {}", trace.name, note.line, note.sentence);
}

}  // namespace continua
