// Traces and runs as annotations.
#pragma once

#include "continua/core/result.h"
#include "continua/replay/annotation/annotations.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// A person's note on records of a run, from `n` to `to`.
struct NoteOnRun {
  std::size_t n = 0, to = 0;
  std::string text;
};

/// The event of the trace that a record `input`, `observed`, `mark` or `expect` at time t tells of, as a trace has it;
/// null where the record comes of no line of the trace, as the end of an act does.
Json event_of_record(const Json& record, SimTime t);

/// The header of a trace as far as the header of its run tells it. The places of objects are those of the scene.
std::string trace_header_of_run(const Json& run);

/// A tier for each kind of event that the trace has; each annotation gives its event back.
Annotations annotations_of_trace(const Trace& trace);

/// The same events as far as the run has them, and the avatar's side: "avatar speech", "avatar gesture" and "avatar
/// act" with how it ended, "state" with the states passed in one millisecond as one annotation `A → B → C`, "stack"
/// with the number of symbols, and "note". Errors: a record cannot be read.
Result<Annotations> annotations_of_run(const RunIndex& run, const std::vector<NoteOnRun>& notes);

}  // namespace continua
