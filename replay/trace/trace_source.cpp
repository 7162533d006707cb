#include "continua/replay/trace/trace_source.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "continua/core/gzip_text.h"
#include "continua/replay/trace/trace_reader.h"

namespace continua {
namespace {

using OpenText = std::function<std::unique_ptr<std::istream>()>;

// A reading of a text that had this digest and no problems.
NextEvent reading_of(std::shared_ptr<TraceReader> reader, const std::string& digest) {
  return [reader = std::move(reader), digest]() -> Result<std::optional<TraceEvent>> {
    auto event = reader->next();
    if (reader->problems().empty() && (event || reader->head().digest == digest)) return event;
    return Error{reader->head().name, "has changed since it was opened; expected a file that stays as it is"};
  };
}

Result<OpenText> text_of(const std::string& path) {
  std::error_code unknown;
  if (is_gzip_file(path)) {
    const auto packed = GzipText::open(path);
    if (!packed) return packed.error();
    // Behind a fault the text would seem to be at its end.
    if (auto damage = (*packed)->read_all([](std::string_view) {})) return *std::move(damage);
    return OpenText([text = *packed] { return stream_of(text); });
  }
  if (std::filesystem::is_regular_file(path, unknown) && std::ifstream(path))
    return OpenText([path] { return std::make_unique<std::ifstream>(path, std::ios::binary); });
  auto text = read_text(path);
  if (!text) return text.error();
  return OpenText([text = *std::move(text)] { return std::make_unique<std::istringstream>(text); });
}

}  // namespace

NextEvent reading_of(const std::vector<TraceEvent>& events) {
  return [next = events.begin(), end = events.end()]() mutable -> Result<std::optional<TraceEvent>> {
    return next == end ? std::optional<TraceEvent>() : *next++;
  };
}

Result<TraceSource> TraceSource::open(const std::string& path) {
  auto text = text_of(path);
  if (!text) return text.error();
  TraceReader reader((*text)(), path);
  Survey survey;
  while (const auto event = reader.next()) survey.see(*event);
  if (!reader.problems().empty()) return reader.problems().front();
  TraceSource source(reader.head(), [text = *std::move(text), path, digest = reader.head().digest] {
    return reading_of(std::make_shared<TraceReader>(text(), path), digest);
  });
  source.survey_ = survey;
  return source;
}

Result<std::vector<TraceEvent>> TraceSource::events() const {
  std::vector<TraceEvent> events;
  const auto next = read();
  while (true) {
    auto event = next();
    if (!event) return event.error();
    if (!*event) return events;
    events.push_back(**std::move(event));
  }
}

Result<TraceSource> TraceSource::with(const TraceSource& edited, SimTime from) const {
  TraceSource spliced(head_, [before = read_, after = edited.read_, from]() -> NextEvent {
    return [first = before(), second = after(), from, passed = false]() mutable -> Result<std::optional<TraceEvent>> {
      if (!passed) {
        auto event = first();
        if (!event || (*event && (*event)->t < from)) return event;
        passed = true;
      }
      auto event = second();
      while (event && *event && (*event)->t < from) event = second();
      return event;
    };
  });
  const auto next = spliced.read();
  while (true) {
    const auto event = next();
    if (!event) return event.error();
    if (!*event) return spliced;
    spliced.survey_.see(**event);
  }
}

void TraceSource::Survey::see(const TraceEvent& event) {
  ++size;
  if (std::holds_alternative<InputEvent>(event.what)) input = event.t;
  if (!std::holds_alternative<Observed>(event.what)) return;
  observes = true;
  at_once = at_once && input == event.t;
}

}  // namespace continua
