#include "continua/replay/commands/table.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "continua/replay/export/tables.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view run_ending = ".run.jsonl";

// The logs named, and those in the folders named, in order.
Result<std::vector<std::string>> logs_of(const std::vector<std::string>& named) {
  std::vector<std::string> logs;
  std::error_code problem;
  for (const auto& path : named) {
    if (!fs::is_directory(path)) {
      logs.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (auto file = fs::recursive_directory_iterator(path, problem); !problem && file != fs::end(file);
         file.increment(problem))
      if (file->path().string().ends_with(run_ending)) found.push_back(file->path().string());
    if (problem) return Error{path, "cannot be read: " + problem.message()};
    if (found.empty()) return Error{path, "has no run logs (.run.jsonl)"};
    std::sort(found.begin(), found.end());
    logs.insert(logs.end(), found.begin(), found.end());
  }
  return logs;
}

std::string name_of_run(std::string path) {
  if (path.ends_with(run_ending)) path.resize(path.size() - run_ending.size());
  return path;
}

Outcome make_folder(const std::string& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem || !fs::is_directory(folder)) return Error{folder, "is no folder and cannot become one"};
  return std::nullopt;
}

// Puts the tables in their places, and says how much is in them.
Outcome finish(TableWriter& tables, const std::string& folder, std::size_t runs) {
  if (auto unwritten = tables.commit()) return unwritten;
  put(stdout,
      fmt::format("{}: {} -> {}\n", counted(runs, "run"), counted(tables.rows(), "row"), printable_line(folder)));
  return std::nullopt;
}

Outcome write_shard(const TableOptions& options, ShardReport& made) {
  const auto logs = logs_of(options.runs);
  if (!logs) return logs.error();
  auto folder = options.output;
  if (made.shard.count > 1)
    folder = (fs::path(folder) / fmt::format("shard-{}-of-{}", made.shard.index, made.shard.count)).string();
  if (auto problem = make_folder(folder)) return problem;
  made.items = logs->size();
  made.numbers = dealt(made.shard, costs_of(*logs));
  TableWriter tables(folder, options.kinds);
  for (const auto item : made.numbers) {
    const auto run = RunIndex::open((*logs)[item]);
    if (!run) return run.error();
    if (auto broken = tables.add(*run, name_of_run((*logs)[item]))) return broken;
    made.told.push_back(compact(tables.latest_part()));
  }
  return finish(tables, folder, made.told.size());
}

Outcome write_merged(const TableOptions& options, const std::vector<std::string>& parts) {
  if (auto problem = make_folder(options.output)) return problem;
  TableWriter tables(options.output, options.kinds);
  for (const auto& text : parts) {
    const auto part = parse_json_line(text, "--merge", 1);
    if (!part) return part.error();
    if (auto problem = tables.add_part(*part)) return problem;
  }
  return finish(tables, options.output, parts.size());
}

}  // namespace

int run_table(const TableOptions& options) {
  if (!options.shards.merge.empty()) {
    const auto merged = merge_shards("table", options.shards.merge);
    if (!merged) return report(merged.error()), exit_impossible;
    if (const auto problem = write_merged(options, merged->told)) return report(*problem), exit_impossible;
    return merged->status;
  }
  ShardReport made{"table", options.shards.shard, 0, {}, exit_done, {}};
  if (const auto problem = write_shard(options, made)) return report(*problem), exit_impossible;
  return keep_report(options.shards, made);
}

void describe_table(CLI::App& command, TableOptions& options) {
  std::vector<std::string> kinds;
  for (const auto& schema : log::schema()) kinds.emplace_back(schema.kind.name);
  command.add_option("RUN", options.runs, "run logs (.run.jsonl), or folders of them");
  command.add_option("-o,--output", options.output, "a folder for the tables")->required();
  command.add_option("--kind", options.kinds, "only records of this kind; also several times")
      ->check(CLI::IsMember(kinds))
      ->allow_extra_args(false);
  add_shard_options(command, options.shards, "RUN", "reading runs");
  command.footer(
      "For each kind of records KIND.csv and KIND.jsonl, with the run's name as `run` in each row, and load.sql, "
      "which\n"
      "makes views with the types of the columns in DuckDB. replay/queries has queries.\n"
      "A shard writes into DIR/shard-I-of-N, which --merge reads.\n"
      "Examples: continua table runs -o tables\n"
      "          continua table runs -o tables --shard 1/2 --report 1.json\n"
      "          continua table --merge 1.json 2.json -o tables");
  command.callback([&options] { expect_items(options.runs, options.shards, "RUN"); });
}

}  // namespace continua
