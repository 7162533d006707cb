// The ingredients of a replay from a trace's header and the options.
#pragma once

#include <optional>
#include <string>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/session/session_parts.h"

namespace continua {

/// Errors: the trace, its scene or its machine cannot be used; a forced transition is not the machine's.
Result<LoadedSession> load_session(const std::string& trace_path, ReplayOptions options);

/// The place of a header in errors.
std::string header_line(const TraceHead& trace);

/// The objects of a header, as a trace writes them.
std::string objects_text(const TraceHeader& header);

/// The files that the option, else the header, names.
Result<std::string> scene_of(const TraceHead& trace, const std::string& option, const DataPaths& data);
Result<std::string> machine_of(const TraceHead& trace, const std::string& option, const DataPaths& data);

/// The scene as the trace's header has its objects; an error of theirs is placed there.
Result<Scene> load_placed(const std::string& path, const TraceHead& trace, Shelf& shelf);

/// The engine that answers the human of a trace, with the options' changes.
Result<EngineParts> load_parts(const TraceHead& trace, const ReplayOptions& options);

/// The options of the run before any change.
ReplayOptions before_change(const ReplayOptions& options);

/// The options' changes from their instant on, if they name one. `trace` gets its events from then on.
Result<std::optional<WhatIf>> load_what_if(TraceSource& trace, const ReplayOptions& options, const DataPaths& data);

}  // namespace continua
