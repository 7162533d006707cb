#include "continua/replay/check/check_failures.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "continua/replay/check/world_pictures.h"
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

using Files = std::vector<std::pair<std::string, std::string>>;  // path, content

// Those of an earlier failure that this one has not. Last of all: until then each file is the old one or the new one.
void remove_others(const std::vector<std::string>& paths, const Files& files) {
  for (const auto& path : paths) {
    const auto is_it = [&](const auto& file) { return file.first == path; };
    std::error_code problem;
    if (std::none_of(files.begin(), files.end(), is_it)) fs::remove(path, problem);
  }
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

  const auto run_path = at(report.name + ".run.jsonl");
  Files files = {{run_path, check.run}};
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
  if (check.compared && report.frames) page.worlds = pictures_of(*check.compared, report.frames);
  page.commands.push_back(fmt::format("continua serve {}", shell_word(report.folder)));
  files.emplace_back(at("report.html"), report_page(page));
  for (const auto& [path, content] : files)
    if (auto unwritten = write_file(path, content)) return *unwritten;
  remove_others(
      {at(report.name + ".approved.run.jsonl"), at(report.name + ".approved.run.json"), at("diff.json"), at("diff.md")},
      files);
  return at("report.html");
}

}  // namespace continua
