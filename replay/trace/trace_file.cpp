#include "continua/replay/trace/trace_file.h"

#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "continua/core/gzip_text.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_reader.h"

namespace continua {

TraceReading read_whole_trace(std::string_view text, const std::string& name) {
  TraceReader reader(std::make_unique<std::istringstream>(std::string(text)), name);
  TraceReading reading;
  while (auto event = reader.next()) reading.trace.events.push_back(*std::move(event));
  static_cast<TraceHead&>(reading.trace) = reader.head();
  reading.problems = reader.problems();
  return reading;
}

Result<Trace> read_trace_text(std::string_view text, const std::string& name) {
  auto reading = read_whole_trace(text, name);
  if (!reading.problems.empty()) return std::move(reading.problems.front());
  return std::move(reading.trace);
}

Result<Trace> read_trace(const std::string& path) {
  const auto text = read_text(path);
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

std::string sentence_of(const TraceHead& trace, const Note& note) {
  return fmt::format("{}:{}: {}", trace.name, note.line, note.sentence);
}

}  // namespace continua
