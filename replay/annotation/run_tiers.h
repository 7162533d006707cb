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

/// A tier for each kind of event that the trace has; each annotation gives its event back.
Annotations annotations_of_trace(const Trace& trace);

/// The same events as far as the run has them, and the avatar's side: "avatar speech", "avatar gesture" and "avatar
/// act" with how it ended, "state" with the states passed in one millisecond as one annotation `A → B → C`, "stack"
/// with the number of symbols, and "note". Errors: a record cannot be read.
Result<Annotations> annotations_of_run(const RunIndex& run, const std::vector<NoteOnRun>& notes);

}  // namespace continua
