#include "continua/replay/commands/pack.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/log/kept_documents.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_log_file.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view log_ending = ".run.jsonl";

Result<std::vector<std::string>> logs_in(const std::string& path) {
  if (!is_folder(path)) return std::vector{path};
  std::vector<std::string> logs;
  std::error_code problem;
  for (fs::recursive_directory_iterator file(path, problem), end; !problem && file != end; file.increment(problem))
    if (file->path().string().ends_with(log_ending)) logs.push_back(file->path().string());
  if (problem) return Error{path, "cannot be read to its end: " + problem.message()};
  if (logs.empty()) return Error{path, fmt::format("has no run log; expected files *{}", log_ending)};
  std::sort(logs.begin(), logs.end());
  return logs;
}

std::string folder_for_documents(const std::string& path) {
  const auto folder = is_folder(path) ? fs::path(path) : fs::path(path).parent_path();
  const auto there = documents_above((folder / "any").string());
  return there ? *there : (fs::absolute(folder).lexically_normal() / "documents").lexically_normal().string();
}

// True: it was rewritten. A log that has no end may still be written by somebody, who would go on with the old file.
Result<bool> repack(const std::string& log, const std::string& documents, bool whole) {
  const auto header = first_line(log);
  if (!header) return header.error();
  if (whole) {
    const auto long_header = with_documents(*header, log);
    if (!long_header) return long_header.error();
    if (*long_header == *header) return false;
  } else {
    const auto run = RunIndex::open(log);
    if (!run) return run.error();
    if (!run->complete()) return Error{log, "has no end; expected the log of a run that is over"};
    if (without_documents(*header).documents.empty()) return false;
  }
  if (auto problem = rewrite_run_log(log, log, whole ? "" : documents)) return *std::move(problem);
  return true;
}

int pack(const std::string& path, bool whole) {
  const auto logs = logs_in(path);
  if (!logs) return report(logs.error()), exit_impossible;
  const auto documents = folder_for_documents(path);
  int status = exit_done;
  std::size_t rewritten = 0;
  for (const auto& log : *logs) {
    const auto done = repack(log, documents, whole);
    if (!done) report(done.error()), status = exit_impossible;
    rewritten += done && *done ? 1 : 0;
  }
  std::error_code unknown;
  std::string removed;
  if (fs::is_directory(documents, unknown)) {
    const auto unused = remove_unused_documents(documents);
    if (!unused) return report(unused.error()), exit_impossible;
    if (*unused > 0) removed = fmt::format(", {} removed that no log needs", counted(*unused, "document"));
    if (whole) fs::remove(documents, unknown);  // where it is empty
  }
  fmt::print("{}: {} of {} rewritten{}\n", path, rewritten, counted(logs->size(), "run log"), removed);
  return status;
}

}  // namespace

int run_pack(const PackOptions& options) {
  int status = exit_done;
  for (const auto& path : options.paths) status = std::max(status, pack(path, options.whole));
  return status;
}

void describe_pack(CLI::App& command, PackOptions& options) {
  command.add_option("PATH", options.paths, "run logs, or folders of them (*.run.jsonl at any depth)")->required();
  command.add_flag("--whole", options.whole, "put the documents back into the logs");
  command.footer(
      "The machine, its phrases, its graph, the scene and the list of knowledge files of each log go to a folder\n"
      "documents: the nearest one from the logs upwards, or a new one in the folder given. Documents there that no\n"
      "log needs any more are removed. All commands read both forms, and see the same bytes.\n"
      "Examples: continua pack runs\n"
      "          continua pack runs --whole");
}

}  // namespace continua
