// The evidence of a failing trace, in a folder of its own: its run, the approved one, their diff, and a page of both.
#pragma once

#include <memory>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/check/check.h"
#include "continua/replay/scene/run_frames.h"

namespace continua {

struct FailureReport {
  std::string folder;                           ///< made where it is missing
  std::string name;                             ///< of the files in it
  std::string trace;                            ///< its path
  std::string replay_options;                   ///< how it was replayed, as on a command line: "", " --no-physics"
  std::shared_ptr<RunFrames> frames = nullptr;  ///< draws the scenes of both runs; null: the page has no pictures
};

/// Writes NAME.run.jsonl, the approved run as NAME.approved.run.jsonl (or .json), diff.json, diff.md and report.html;
/// files of an earlier failure that this one does not write are removed. Gives the path of report.html. REQUIRES a run.
Result<std::string> write_failure(const FailureReport& report, const TraceCheck& check);

/// The differences, as Markdown; empty where nothing can be compared.
std::string details_of(const TraceCheck& check);

}  // namespace continua
