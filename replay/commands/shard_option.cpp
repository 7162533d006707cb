#include "continua/replay/commands/shard_option.h"

#include <CLI/CLI.hpp>

#include "continua/replay/terminal/terminal.h"

namespace continua {

void add_shard_option(CLI::App& command, Shard& shard) {
  command
      .add_option_function<std::string>(
          "--shard",
          [&shard](const std::string& text) {
            const auto told = parse_shard(text);
            if (!told) throw CLI::ValidationError("--shard", told.error().sentence);
            shard = *told;
          },
          "I/N: only part I of N, from 1, of about as many bytes of inputs as each other part; auto: as a task of "
          "Slurm, GitLab or CircleCI is told")
      ->type_name("I/N");
}

void add_shard_options(CLI::App& command, ShardOptions& options, const std::string& items, const std::string& doing) {
  add_shard_option(command, options.shard);
  command.add_option("--report", options.report, "write what came out to this file, as JSON that --merge reads");
  command.add_option("--merge", options.merge, "tell the reports of all shards as one, instead of " + doing)
      ->excludes(items);
}

void expect_items(const std::vector<std::string>& items, const ShardOptions& options, const std::string& name) {
  if (items.empty() && options.merge.empty()) throw CLI::RequiredError(name);
}

int keep_report(const ShardOptions& options, const ShardReport& made) {
  if (options.report.empty()) return made.status;
  const auto problem = write_file(options.report, text_of(made));
  if (problem) report(*problem);
  return problem ? exit_impossible : made.status;
}

}  // namespace continua
