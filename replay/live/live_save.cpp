#include "continua/replay/live/live_save.h"

#include <filesystem>

#include <fmt/format.h>

#include "continua/core/replaced_file.h"
#include "continua/replay/check/check.h"
#include "continua/replay/live/live_trace.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

// Approves the trace's run in this world, unless that run is approved already.
Outcome approve(const std::string& trace_path, bool physics, const std::string& knowledge,
                std::vector<std::string>& runs) {
  ReplayOptions options;
  options.knowledge = knowledge;
  options.physics = physics;
  const auto checked = check_trace(trace_path, options);
  if (!can_be_approved(checked.verdict))
    return is_failure(checked.verdict) ? Outcome(Error{trace_path, checked.reason}) : std::nullopt;
  const auto approval = approval_of(trace_path, checked.run, checked.approved);
  runs.push_back(approval.path);
  return replace_file(approval.path, approval.content);
}

}  // namespace

Result<SavedTest> save_as_test(const std::string& trace_path, const std::string& folder, const std::string& name,
                               const std::string& knowledge) {
  auto trace = read_so_far(trace_path);
  if (!trace) return trace.error();
  move_header(trace->header, trace_path, folder);

  std::error_code problem;
  fs::create_directories(folder, problem);
  SavedTest saved;
  saved.trace = (fs::path(folder) / (name + ".trace.jsonl")).string();
  if (fs::exists(saved.trace, problem)) return Error{saved.trace, "exists already; expected another name"};
  auto failed = replace_file(saved.trace, write_trace(*trace));
  for (const bool physics : {false, true})
    if (!failed) failed = approve(saved.trace, physics, knowledge, saved.runs);
  if (failed) {
    fs::remove(saved.trace, problem);
    for (const auto& run : saved.runs) fs::remove(run, problem);
    return *failed;
  }
  saved.check = fmt::format("continua check {}", saved.trace);
  return saved;
}

}  // namespace continua
