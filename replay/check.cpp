#include "replay/check.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "core/located_json.h"

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

// The first `expect` record that says so.
std::string unmet_expectation(const std::string& run, const std::string& trace_path) {
  std::istringstream lines(run);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("\"met\":false") == std::string::npos) continue;
    const auto record = parse_json_line(line, trace_path, 1);
    if (!record || (*record)["kind"] != "expect") continue;
    return fmt::format("{}:{}: expected {}, found {}", trace_path, compact((*record)["line"]),
                       compact((*record)["expected"]), compact((*record)["found"]));
  }
  return trace_path + ": an expectation is not met";
}

}  // namespace

const char* text(Verdict verdict) {
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
  std::string run = std::move(log).str();
  if (summary.expectations_met < summary.expectations) return broken(unmet_expectation(run, trace_path));

  auto approved = find_approved_run(trace_path, options.physics ? "physics" : "kinematic");
  if (!approved) return broken(approved.error().text());
  check.approved = *std::move(approved);
  if (check.approved) {
    auto comparison = compare_to_approved(run, *check.approved);
    if (!comparison) return broken(comparison.error().text());
    check.verdict = verdict_of(comparison->sameness);
    check.reason = std::move(comparison->difference);
    if (check.verdict == Verdict::stale) check.reason = check.approved->path + " was made from another trace";
  } else {
    check.verdict = Verdict::unapproved;
    check.reason = "no run is approved";
  }
  if (can_be_approved(check.verdict)) check.run = std::move(run);
  return check;
}

}  // namespace continua
