// The changes of a run from an instant on.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "continua/replay/session/session_load.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// The edited trace, whose scene cannot be another one: the world is in the midst of it.
Result<TraceSource> open_edited(const TraceHead& original, const ReplayOptions& options, const DataPaths& data) {
  auto edited = TraceSource::open(options.with);
  if (!edited) return edited.error();
  const auto cannot = [&](const char* what) {
    return Error{header_line(edited->head()),
                 fmt::format("found {} than in {}; expected the same, since they cannot change in mid-run", what,
                             header_line(original))};
  };
  if (options.scene.empty()) {
    const auto was = scene_of(original, "", data);
    if (!was) return was.error();
    const auto now = edited->head().header.scene.empty() ? was : scene_of(edited->head(), "", data);
    if (!now) return now.error();
    std::error_code unknown;
    if (*was != *now && !fs::equivalent(*was, *now, unknown)) return cannot("another 'scene'");
  }
  if (objects_text(original.header) != objects_text(edited->head().header)) return cannot("other 'objects'");
  return edited;
}

// Where the edited trace names no machine, the machine and the language are the original's.
Result<TraceHead> with_machine_of(TraceHead edited, const TraceHead& original, const DataPaths& data) {
  if (!edited.header.machine.empty()) return edited;
  auto machine = machine_of(original, "", data);
  if (!machine) return machine.error();
  edited.header.machine = *std::move(machine);
  if (edited.header.language.empty()) edited.header.language = original.header.language;
  return edited;
}

// The notes on lines of the edited trace from the instant on, but those on the trace's own.
Result<std::vector<Note>> notes_of(const TraceSource& edited, SimTime from, const TraceHead& trace) {
  const auto next = edited.read();
  auto event = next();
  while (event && *event && (*event)->t < from) event = next();
  if (!event) return event.error();
  std::vector<Note> notes;
  for (const auto& note : edited.head().notes) {
    const auto same = [&](const Note& one) { return one.line == note.line && one.sentence == note.sentence; };
    const bool known = std::any_of(trace.notes.begin(), trace.notes.end(), same);
    if (*event && note.line >= (*event)->line && !known) notes.push_back(note);
  }
  return notes;
}

// Puts the edited trace's events from the instant on in the place of the trace's own.
Outcome splice(TraceSource& trace, const TraceSource& edited, WhatIf& what_if) {
  auto notes = notes_of(edited, what_if.from, trace.head());
  if (!notes) return notes.error();
  what_if.notes = *std::move(notes);
  what_if.trace = {name_in_log(edited.head().name), edited.head().digest};
  auto spliced = trace.with(edited, what_if.from);
  if (!spliced) return spliced.error();
  trace = *std::move(spliced);
  return std::nullopt;
}

}  // namespace

ReplayOptions before_change(const ReplayOptions& options) {
  if (!options.from) return options;
  if (options.before) return *options.before;
  ReplayOptions before;
  before.scene = options.scene;
  before.learned = options.learned;
  return before;
}

Result<std::optional<WhatIf>> load_what_if(TraceSource& trace, const ReplayOptions& options, const DataPaths& data) {
  if (!options.from) {
    if (options.with.empty()) return std::optional<WhatIf>();
    return Error{"--with", "found no --from; expected the instant from which on the trace's events are those of this"};
  }
  WhatIf what_if;
  what_if.from = SimTime::from_seconds(*options.from);
  auto head = Result<TraceHead>(trace.head());
  if (!options.with.empty()) {
    const auto edited = open_edited(trace.head(), options, data);
    if (!edited) return edited.error();
    head = with_machine_of(edited->head(), trace.head(), data);
    if (!head) return head.error();
    if (const auto problem = splice(trace, *edited, what_if)) return *problem;
  }
  auto parts = load_parts(*head, options);
  if (!parts) return parts.error();
  what_if.parts = std::move(*parts);
  return std::optional(std::move(what_if));
}

}  // namespace continua
