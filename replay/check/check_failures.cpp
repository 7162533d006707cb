#include "continua/replay/check/check_failures.h"

#include <filesystem>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/export/run_report.h"
#include "continua/replay/terminal/shell_word.h"
#include "continua/replay/terminal/terminal.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

std::string ending_of(const ApprovedRun& approved) {
  return is_whole_log(approved) ? ".approved.run.jsonl" : ".approved.run.json";
}

}  // namespace

std::string details_of(const TraceCheck& check) {
  const auto& compared = check.compared;
  return compared ? diff_markdown(compared->approved, compared->run, compared->diff) : "";
}

Result<std::string> write_failure(const FailureReport& report, const TraceCheck& check) {
  require(!check.run.empty(), "a failure is shown by its run");
  const fs::path folder = report.folder;
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) return Error{report.folder, fmt::format("cannot be made: {}", problem.message())};
  const auto at = [&](const std::string& name) { return (folder / name).string(); };
  for (const auto& name : {report.name + ".approved.run.jsonl", report.name + ".approved.run.json",
                           std::string("diff.json"), std::string("diff.md")})
    fs::remove(at(name), problem);

  const auto run_path = at(report.name + ".run.jsonl");
  std::vector<std::pair<std::string, std::string>> files = {{run_path, check.run}};
  RunReport page{report.trace, name_of(check.verdict), check.reason, nullptr, nullptr, nullptr, {}};
  page.commands = {
      fmt::format("continua replay {}{} -o {}", shell_word(report.trace), report.replay_options, shell_word(run_path))};
  if (check.approved) files.emplace_back(at(report.name + ending_of(*check.approved)), check.approved->content);
  const auto alone = check.compared ? std::nullopt : std::optional(RunIndex::of_text(check.run, run_path));
  if (alone && !*alone) return alone->error();
  if (const auto& compared = check.compared) {
    const auto& [approved, run, diff] = *compared;
    page.run = &run;
    page.approved = &approved;
    page.diff = &diff;
    page.commands.push_back(fmt::format("continua diff {} {}", shell_word(check.approved->path), shell_word(run_path)));
    const auto json = diff_json(approved, run, diff).dump(1, ' ', false, Json::error_handler_t::replace);
    files.emplace_back(at("diff.json"), json + "\n");
    files.emplace_back(at("diff.md"), details_of(check));
  } else {
    page.run = &**alone;
  }
  files.emplace_back(at("report.html"), report_page(page));
  for (const auto& [path, content] : files)
    if (auto unwritten = write_file(path, content)) return *unwritten;
  return at("report.html");
}

}  // namespace continua
