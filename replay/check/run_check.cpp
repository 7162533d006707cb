#include "continua/replay/check/run_check.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "continua/core/growing_file.h"
#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/check/check_approval.h"
#include "continua/replay/check/check_summary.h"
#include "continua/replay/check/junit.h"

namespace continua {
namespace {

std::vector<JunitCase> junit_cases(const CheckReport& report) {
  std::vector<JunitCase> cases;
  for (const auto& one : report.cases) {
    const std::filesystem::path path = one.path;
    std::string failure = one.status == exit_done ? "" : one.sentence;
    for (const auto& problem : one.problems) failure += "; " + problem.text();
    cases.push_back({path.parent_path().string(), path.filename().string(), failure});
  }
  return cases;
}

Outcome append(const std::string& path, const std::string& text) {
  GrowingFile file(path, GrowingFile::Begin::after);
  if (auto unwritten = file.add(text)) return *unwritten;
  return file.close();
}

Outcome write_reports(const CheckOptions& options, const CheckReport& report) {
  if (!options.junit.empty())
    if (auto problem = write_file(options.junit, junit_xml("continua check", junit_cases(report)))) return problem;
  if (!options.summary.empty())
    if (auto problem = append(options.summary, markdown_of(report))) return problem;
  if (options.report.empty()) return std::nullopt;
  return write_file(options.report, json_of(report).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

// The total, the reports, and the status all of it has.
int conclude(const CheckOptions& options, const CheckReport& report, const std::vector<Error>& problems) {
  fmt::print("{}\n", total_of(report));
  std::fflush(stdout);
  for (const auto& problem : problems) continua::report(problem);
  if (const auto problem = write_reports(options, report)) return continua::report(*problem), exit_impossible;
  return problems.empty() ? report.status() : exit_impossible;
}

int run_merge(const CheckOptions& options) {
  if (const auto problem = not_an_input({options.junit, options.report, options.summary}, options.merge))
    return report(*problem), exit_impossible;
  std::vector<CheckReport> reports;
  for (const auto& path : options.merge) {
    const auto text = read_file(path);
    if (!text) return report(text.error()), exit_impossible;
    auto one = read_report(*text, path);
    if (!one) return report(one.error()), exit_impossible;
    reports.push_back(*std::move(one));
  }
  const auto all = merged(options.merge, reports);
  for (const auto& one : all.report.cases) tell(one, options.github);
  return conclude(options, all.report, all.problems);
}

}  // namespace

int run_check(const CheckOptions& options) {
  if (!options.merge.empty()) return run_merge(options);
  const auto begun = std::chrono::steady_clock::now();
  const auto data = find_data_paths(options.knowledge);
  if (!data) return report(data.error()), exit_impossible;
  auto all = items_of(options.paths.empty() ? std::vector{data->knowledge.string()} : options.paths);
  if (!all) return report(all.error()), exit_impossible;
  std::vector<std::string> inputs;
  for (const auto& item : *all) inputs.push_back(item.path.string());
  const auto numbers = dealt(options.shard, costs_of(inputs));
  std::vector<CheckItem> items;
  for (const auto number : numbers) items.push_back((*all)[number]);

  if (const auto problem = not_an_input({options.junit, options.report, options.summary}, inputs))
    return report(*problem), exit_impossible;

  Checking checking(options, *data, items);
  checking.run();
  CheckReport report{options.shard, all->size(), numbers, 0, checking.cases()};
  std::vector<Error> problems;
  if (options.approve)
    if (auto problem = approve(options, items, checking, report.cases)) problems.push_back(std::move(*problem));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return conclude(options, report, problems);
}

}  // namespace continua
