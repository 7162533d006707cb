#include "replay/commands/check.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "replay/commands/check_approval.h"
#include "replay/commands/check_summary.h"
#include "replay/commands/junit.h"

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
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << text;
  file.close();
  if (!file) return Error{path, "cannot be written; expected a file that can be added to"};
  return std::nullopt;
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

bool on_github() {
  const char* set = std::getenv("GITHUB_ACTIONS");
  return set && std::string_view(set) == "true";
}

}  // namespace

int run_check(const CheckOptions& options) {
  if (!options.merge.empty()) return run_merge(options);
  const auto begun = std::chrono::steady_clock::now();
  const auto data = find_data_paths(options.knowledge);
  if (!data) return report(data.error()), exit_impossible;
  auto all = items_of(options.paths.empty() ? std::vector{data->knowledge.string()} : options.paths);
  if (!all) return report(all.error()), exit_impossible;
  std::vector<CheckItem> items;
  for (std::size_t i = options.shard.index - 1; i < all->size(); i += options.shard.count) items.push_back((*all)[i]);

  Checking checking(options, *data, items);
  checking.run();
  CheckReport report{options.shard, all->size(), 0, checking.cases()};
  std::vector<Error> problems;
  if (options.approve)
    if (auto problem = approve(options, items, checking, report.cases)) problems.push_back(std::move(*problem));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return conclude(options, report, problems);
}

void add_check_command(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand(
      "check", "Check what the project's files say of themselves, and hold traces against their approved runs");
  auto options = std::make_shared<CheckOptions>();
  options->failures = "check-failures";
  command->add_option("PATH", options->paths,
                      "machines, folders of lexicon/, phrases, gestures, folders voxemes, traces, or folders of them;\n"
                      "the knowledge folder if left out");
  command->add_option("--knowledge", options->knowledge, "folder to use instead of engine/knowledge");
  command->add_option("--learned", options->learned,
                      "a file of what was taught: traces read it if it exists, and write what they change");
  auto* physics = command->add_flag_callback(
      "--physics", [options] { options->physics = true; },
      "replay traces in MuJoCo's world, also with --approve, which else takes the kinematic one");
  command
      ->add_flag_callback(
          "--no-physics", [options] { options->physics = false; },
          "replay traces in the kinematic world, where every act succeeds")
      ->excludes(physics);
  command->add_flag("--strict", options->strict, "that only the decisions are the same is a failure too");
  auto* approve =
      command->add_flag("--approve", options->approve,
                        "show what is new or not as approved, ask, then write these runs beside their traces");
  command->add_flag("--yes", options->yes, "with --approve: do not ask")->needs(approve);
  command->add_option("-j,--jobs", options->jobs, "how many files at a time")->check(CLI::Range(1, 256));
  auto shard = std::make_shared<std::string>();
  command->add_option("--shard", *shard, "I/N: only part I of N, from 1")->check([](const std::string& text) {
    return parse_shard(text) ? std::string() : fmt::format("found {}; expected I/N, I from 1 to N", in_quotes(text));
  });
  command->add_option("--report", options->report, "write what came out to this file, as JSON that --merge reads");
  command->add_option("--merge", options->merge, "tell the reports of all shards as one, instead of checking")
      ->excludes(approve)
      ->excludes("PATH");
  command->add_option("--junit", options->junit, "write what came out to this file, as JUnit's XML");
  command->add_option("--summary", options->summary, "add what came out to this file, as Markdown");
  command->add_flag("--github", options->github,
                    "tell failures as GitHub's annotations too; on its own where GITHUB_ACTIONS is true");
  command->add_option(
      "--failures", options->failures,
      "folder for what shows why a trace fails, a folder for each: its run, the approved one, their diff\n"
      "and report.html; check-failures if left out, '' for none. Not with --approve");
  command->footer(
      "Of a trace: same (every byte), same decisions (as in another world), new (nothing is approved), changed,\n"
      "stale (approved from another trace), broken (cannot be replayed, or an expectation is not met).\n"
      "Exit status: 0 all is true, 1 something is not, 2 a file cannot be used, or a shard's report is missing.\n"
      "Examples: continua check traces -j 4\n"
      "          continua check traces --approve\n"
      "          continua check traces --shard 1/2 --report 1.json\n"
      "          continua check --merge 1.json 2.json --junit all.xml");
  command->callback([options, shard, &run] {
    if (!shard->empty()) options->shard = *parse_shard(*shard);
    options->github = options->github || on_github();
    run = [options] { return run_check(*options); };
  });
}

}  // namespace continua
