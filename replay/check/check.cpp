#include "continua/replay/check/check.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/log/kinds.h"
#include "continua/simulation/mujoco_version.h"

namespace continua {
namespace {

Verdict verdict_of(Sameness sameness) {
  switch (sameness) {
    case Sameness::same:
      return Verdict::same;
    case Sameness::same_decisions:
      return Verdict::same_decisions;
    case Sameness::changed:
      return Verdict::changed;
    case Sameness::stale:
      return Verdict::stale;
  }
  return Verdict::broken;
}

// The line of the trace whose input led to where the runs part; 0: none did.
std::size_t line_of(const RunDiff& diff, const RunIndex& run) {
  if (diff.first >= diff.differences.size()) return 0;
  auto records = diff.led_b;
  const auto& differing = diff.differences[diff.first].b;
  records.insert(records.end(), differing.begin(), differing.end());
  for (const auto n : records) {
    if (!log::is<log::Input>(run.kind(n))) continue;
    const auto input = run.record(n);
    if (input && input->contains("line") && (*input)["line"].is_number_unsigned())
      return (*input)["line"].get<std::size_t>();
  }
  return 0;
}

}  // namespace

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::same:
      return "same";
    case Verdict::same_decisions:
      return "same decisions";
    case Verdict::unapproved:
      return "new";
    case Verdict::changed:
      return "changed";
    case Verdict::stale:
      return "stale";
    case Verdict::broken:
      return "broken";
  }
  return "";
}

bool is_failure(Verdict verdict) {
  return verdict == Verdict::changed || verdict == Verdict::stale || verdict == Verdict::broken;
}

bool can_be_approved(Verdict verdict) {
  return verdict == Verdict::unapproved || verdict == Verdict::changed || verdict == Verdict::stale;
}

TraceCheck check_trace(const std::string& trace_path, const ReplayOptions& options) {
  TraceCheck check;
  const auto broken = [&](std::string reason) {
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    check.verdict = Verdict::broken;
    check.reason = std::move(reason);
    return check;
  };
  auto session = Session::load(trace_path, options);
  if (!session) return broken(session.error().text());
  check.warning = session->warning();
  std::ostringstream log;
  const auto summary = session->run(log);
  if (const auto problem = session->keep_learned()) return broken(problem->text());
  check.expectations = summary.expectations;
  check.run = std::move(log).str();

  auto approved = find_approved_run(trace_path, options.physics ? "physics" : "kinematic", mujoco_version());
  if (approved) check.approved = *std::move(approved);
  if (summary.expectations_met < summary.expectations) {
    compare(check);
    const auto& unmet = summary.unmet.front();
    check.line = unmet.line;
    return broken(unmet.error(trace_path).text());
  }
  if (!approved) return broken(approved.error().text());
  if (!check.approved) {
    check.verdict = Verdict::unapproved;
    check.reason = "no run is approved";
    return check;
  }
  auto comparison = compare_to_approved(check.run, *check.approved);
  if (!comparison) return broken(comparison.error().text());
  check.verdict = verdict_of(comparison->sameness);
  check.reason = std::move(comparison->difference);
  if (check.verdict == Verdict::same) check.run.clear();
  if (check.verdict == Verdict::changed || check.verdict == Verdict::stale)
    if (const auto problem = compare(check)) check.reason += ", and where cannot be told: " + problem->text();
  if (check.verdict == Verdict::changed && check.compared) check.reason = check.compared->diff.sentence;
  if (check.verdict == Verdict::changed && options.physics)
    if (const auto others = other_mujocos(trace_path, *check.approved, mujoco_version()); !others.empty())
      check.reason += fmt::format(" (approved with {}; this is {})", others, mujoco_version());
  if (check.verdict == Verdict::stale) check.reason = check.approved->path + " was made from another trace";
  return check;
}

Outcome compare(TraceCheck& check) {
  if (check.compared || !check.approved || !is_whole_log(*check.approved) || check.run.empty()) return std::nullopt;
  auto approved = RunIndex::of_text(check.approved->content, check.approved->path);
  if (!approved) return approved.error();
  auto run = RunIndex::of_text(check.run, "the run");
  if (!run) return run.error();
  auto diff = diff_runs(*approved, *run);
  if (!diff) return diff.error();
  check.line = line_of(*diff, *run);
  check.compared = ComparedRuns{*std::move(approved), *std::move(run), *std::move(diff)};
  return std::nullopt;
}

}  // namespace continua
