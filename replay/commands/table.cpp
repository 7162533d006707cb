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

}  // namespace

int run_table(const TableOptions& options) {
  const auto fail = [](const Error& error) {
    report(error);
    return exit_impossible;
  };
  const auto logs = logs_of(options.runs);
  if (!logs) return fail(logs.error());
  std::error_code problem;
  fs::create_directories(options.output, problem);
  if (problem || !fs::is_directory(options.output)) return fail({options.output, "is no folder and cannot become one"});
  TableWriter tables(options.output, options.kinds);
  for (const auto& log : *logs) {
    const auto run = RunIndex::open(log);
    if (!run) return fail(run.error());
    if (const auto broken = tables.add(*run, name_of_run(log))) return fail(*broken);
  }
  if (const auto unwritten = tables.commit()) return fail(*unwritten);
  fmt::print("{}: {} -> {}\n", counted(logs->size(), "run"), counted(tables.rows(), "row"),
             printable_line(options.output));
  return exit_done;
}

void describe_table(CLI::App& command, TableOptions& options) {
  std::vector<std::string> kinds;
  for (const auto& schema : log::schema()) kinds.emplace_back(schema.kind.name);
  command.add_option("RUN", options.runs, "run logs (.run.jsonl), or folders of them")->required();
  command.add_option("-o,--output", options.output, "a folder for the tables")->required();
  command.add_option("--kind", options.kinds, "only records of this kind; also several times")
      ->check(CLI::IsMember(kinds))
      ->allow_extra_args(false);
  command.footer(
      "For each kind of records KIND.csv and KIND.jsonl, with the run's name as `run` in each row, and load.sql, "
      "which\n"
      "makes views with the types of the columns in DuckDB. replay/queries has queries.\n"
      "Example: continua table runs -o tables");
}

}  // namespace continua
