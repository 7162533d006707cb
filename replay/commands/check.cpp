#include "continua/replay/commands/check.h"

#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/located_json.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/commands/shard_option.h"

namespace continua {
namespace {

bool on_github() {
  const char* set = std::getenv("GITHUB_ACTIONS");
  return set && std::string_view(set) == "true";
}

}  // namespace

void describe_check(CLI::App& command, CheckOptions& options) {
  options.failures = "check-failures";
  command.add_option("PATH", options.paths,
                     "machines, folders of lexicon/, phrases, gestures, folders voxemes, traces, or folders of them;\n"
                     "the knowledge folder if left out");
  command.add_option("--knowledge", options.knowledge, "folder to use instead of engine/knowledge");
  add_set_option(command, options.settings);
  command.add_option("--language", options.language,
                     "replay traces in this language, a name in knowledge/lexicon; otherwise in their own");
  command.add_option("--learned", options.learned,
                     "a file of what was taught: traces read it if it exists, and write what they change");
  auto* physics = command.add_flag_callback(
      "--physics", [&options] { options.physics = true; },
      "replay traces in MuJoCo's world, also with --approve, which else takes the kinematic one");
  command
      .add_flag_callback(
          "--no-physics", [&options] { options.physics = false; },
          "replay traces in the kinematic world, where every act succeeds")
      ->excludes(physics);
  command.add_flag("--strict", options.strict, "that only the decisions are the same is a failure too");
  auto* approve =
      command.add_flag("--approve", options.approve,
                       "show what is new or not as approved, ask, then write these runs beside their traces");
  command.add_flag("--yes", options.yes, "with --approve: do not ask")->needs(approve);
  command.add_option("-j,--jobs", options.jobs, "how many files at a time")->check(CLI::Range(1, 256));
  add_shard_option(command, options.shard);
  command.add_option("--report", options.report, "write what came out to this file, as JSON that --merge reads");
  command.add_option("--merge", options.merge, "tell the reports of all shards as one, instead of checking")
      ->excludes(approve)
      ->excludes("PATH");
  command.add_option("--junit", options.junit, "write what came out to this file, as JUnit's XML");
  command.add_option("--summary", options.summary, "add what came out to this file, as Markdown");
  command.add_flag("--github", options.github,
                   "tell failures as GitHub's annotations too; on its own where GITHUB_ACTIONS is true");
  command.add_option(
      "--failures", options.failures,
      "folder for what shows why a trace fails, a folder for each: its run, the approved one, their diff\n"
      "and report.html; check-failures if left out, '' for none. Not with --approve");
  command.footer(
      "Of a trace: same (every byte), same decisions (as in another world), new (nothing is approved), changed,\n"
      "stale (approved from another trace), broken (cannot be replayed, or an expectation is not met).\n"
      "Exit status: 0 all is true, 1 something is not, 2 a file cannot be used, or a shard's report is missing.\n"
      "Examples: continua check traces -j 4\n"
      "          continua check traces --approve\n"
      "          continua check traces --shard 1/2 --report 1.json\n"
      "          continua check --merge 1.json 2.json --junit all.xml");
  command.callback([&options] { options.github = options.github || on_github(); });
}

}  // namespace continua
