#include "continua/replay/experiment/shrink_against.h"

#include <fstream>
#include <sstream>

#include "continua/core/scratch_space.h"
#include "continua/replay/diff/run_diff.h"

namespace continua {
namespace {

std::optional<Json> cause_of(const RunIndex& then, const RunIndex& now) {
  const auto diff = diff_runs(then, now);
  if (!diff || is_same(*diff)) return std::nullopt;
  return Json{{"kind", diff->cause.kind}, {"what", diff->cause.what}};
}

Result<std::string> log_of_trace(const std::string& path, const ReplayOptions& options) {
  auto session = Session::load(path, options);
  if (!session) return session.error();
  std::ostringstream log;
  session->run(log);
  return std::move(log).str();
}

// The trace as this document of a machine has it; nothing if it cannot be loaded with it.
std::optional<Session> with_machine(const Json& document, const std::string& trace_path, ReplayOptions options) {
  const auto folder = ScratchSpace::make();
  if (!folder) return std::nullopt;
  options.machine = (folder->path() / "machine.json").string();
  std::ofstream(options.machine, std::ios::binary) << compact(document);
  auto session = Session::load(trace_path, options);
  if (!session) return std::nullopt;
  return std::move(*session);
}

}  // namespace

Result<ShrinkAgainst> ShrinkAgainst::load(const std::string& path, const std::string& trace_path,
                                          const ReplayOptions& options, const std::string& now) {
  auto run = RunIndex::open(path);
  if (!run) {
    const auto trace = read_trace(path);
    if (!trace) return run.error();
    auto log = log_of_trace(path, options);
    if (!log) return log.error();
    run = RunIndex::of_text(std::move(*log), path);
    if (!run) return run.error();
  }
  ShrinkAgainst against(std::move(*run));
  const auto& header = against.run_.header();
  const auto present = RunIndex::of_text(now, trace_path);
  if (!header || !present || !header->is_object() || !header->contains("machine")) return against;
  const auto& machine = (*header)["machine"];
  const auto& present_header = present->header();
  if (!present_header || !machine.is_object() || !machine.contains("document")) return against;
  if (machine["document"] == (*present_header)["machine"]["document"]) return against;
  // Only if the machine made the difference.
  auto then = with_machine(machine["document"], trace_path, options);
  if (!then) return against;
  std::ostringstream log;
  then->run(log);
  const auto again = RunIndex::of_text(std::move(log).str(), path);
  if (again && cause_of(*again, *present) == cause_of(against.run_, *present)) against.then_ = std::move(then);
  return against;
}

std::optional<Json> ShrinkAgainst::cause(const Trace& trace, const std::string& log) {
  const auto now = RunIndex::of_text(log, "now");
  if (!now) return std::nullopt;
  if (!then_) return cause_of(run_, *now);
  std::ostringstream text;
  if (!then_->run(trace, {}, text)) return std::nullopt;
  const auto then = RunIndex::of_text(std::move(text).str(), "then");
  return then ? cause_of(*then, *now) : std::nullopt;
}

}  // namespace continua
