// The ingredients of a replay: loaded once, shared by every replay of a session.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "continua/body/body.h"
#include "continua/knowledge_files/engine_parts.h"
#include "continua/learning/learning.h"
#include "continua/pipeline/pipeline.h"
#include "continua/replay/log/records_of_log.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/trace_source.h"
#include "continua/simulation/scene.h"

namespace continua {

/// The parts that count from an instant of the run on.
struct WhatIf {
  SimTime from;
  EngineParts parts;                                         ///< scene, world and lessons from before the run stay
  std::optional<std::pair<std::string, std::string>> trace;  ///< name and digest of that of the events from then on
  std::vector<Note> notes;                                   ///< on its lines, but those on the trace's own
};

struct LoadedSession {
  ReplayOptions options;  ///< with a shelf
  TraceSource trace;      ///< with the events of WhatIf from then on
  std::string placed;     ///< the objects of the header that the scene was set out with, as a trace writes them
  EngineParts parts;
  std::optional<WhatIf> what_if;
  Scene scene;
  Learned learned;  ///< when the run begins
  std::optional<Error> warning;
  log::Run header;  ///< header_of() the rest
  std::optional<Learned> learned_at_end;

  std::size_t most_branches() const { return options.most_branches ? options.most_branches : default_most_branches; }
};

/// The header of the run log (RECORDS.md, `run`).
log::Run header_of(const LoadedSession& loaded);

/// A world as the scene has it at the beginning. Errors: the scene's avatar is incomplete.
Result<std::unique_ptr<Body>> body_of(const Scene& scene, bool physics);

}  // namespace continua
