#include "continua/replay/commands/pack.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/gzip_name.h"
#include "continua/core/gzip_text.h"
#include "continua/core/replaced_file.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/log/kept_documents.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_log_file.h"
#include "continua/replay/trace/trace_file.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view log_ending = ".run.jsonl";

Result<std::vector<std::string>> logs_in(const std::string& path) {
  if (!is_folder(path)) return std::vector{path};
  std::vector<std::string> logs;
  std::error_code problem;
  for (fs::recursive_directory_iterator file(path, problem), end; !problem && file != end; file.increment(problem))
    if (without_gzip_ending(file->path().string()).ends_with(log_ending)) logs.push_back(file->path().string());
  if (problem) return Error{path, "cannot be read to its end: " + problem.message()};
  if (logs.empty()) return Error{path, fmt::format("has no run log; expected files *{}, packed or not", log_ending)};
  std::sort(logs.begin(), logs.end());
  return logs;
}

std::string folder_for_documents(const std::string& path) {
  const auto folder = is_folder(path) ? fs::path(path) : fs::absolute(path).parent_path();
  const auto there = documents_above((folder / "any").string());
  return there ? *there : (fs::absolute(folder).lexically_normal() / "documents").lexically_normal().string();
}

// The name that a file has afterwards. An error if another file has it.
Result<std::string> name_after(const std::string& path, const PackOptions& options) {
  if (!options.gzip) return path;
  auto name = fmt::format("{}{}", without_gzip_ending(path), *options.gzip ? gzip_ending : "");
  std::error_code unknown;
  if (name != path && fs::exists(name, unknown))
    return Error{name, fmt::format("exists already beside {}; expected one of them", path)};
  return name;
}

// A file that may still be written is left alone: its writer would go on with the old one.
Error has_no_end(const std::string& path, const char* of) {
  return Error{path, fmt::format("has no end; expected the {} that is over", of)};
}

// True: it was rewritten.
Result<bool> repack(const std::string& log, const std::string& documents, const PackOptions& options) {
  const auto header = first_line(log);
  if (!header) return header.error();
  const auto name = name_after(log, options);
  if (!name) return name.error();
  const auto long_header = with_documents(*header, log);
  if (!long_header) return long_header.error();
  const bool same_form = options.whole ? *long_header == *header : without_documents(*header).documents.empty();
  if (!options.whole || *name != log) {
    const auto run = RunIndex::open(log);
    if (!run) return run.error();
    if (!run->complete()) return has_no_end(log, "log of a run");
  }
  if (same_form && *name == log) return false;
  if (auto problem = rewrite_run_log(log, *name, options.whole ? "" : documents)) return *std::move(problem);
  std::error_code unknown;
  if (*name != log)
    for (const auto& old : {log, log + ".index"}) fs::remove(old, unknown);
  return true;
}

int pack_trace(const std::string& path, const PackOptions& options) {
  const auto fail = [](const Error& error) { return report(error), exit_impossible; };
  if (!options.gzip) return fail({path, "is a trace; expected run logs, or --gzip or --no-gzip"});
  const auto name = name_after(path, options);
  if (!name) return fail(name.error());
  const auto text = read_text(path);
  if (!text) return fail(text.error());
  const auto trace = read_trace_text(*text, path);
  if (!trace) return fail(trace.error());
  if (trace->events.empty() || !std::holds_alternative<End>(trace->events.back().what))
    return fail(has_no_end(path, "trace of a session"));
  if (*name != path) {
    if (auto problem = replace_file(*name, *text)) return fail(*problem);
    std::error_code unknown;
    fs::remove(path, unknown);
  }
  fmt::print("{}: {}\n", path, *name == path ? "as it was" : "rewritten as " + *name);
  return exit_done;
}

int pack(const std::string& path, const PackOptions& options) {
  if (is_trace_name(path) && !is_folder(path)) return pack_trace(path, options);
  const auto logs = logs_in(path);
  if (!logs) return report(logs.error()), exit_impossible;
  const auto documents = folder_for_documents(path);
  int status = exit_done;
  std::size_t rewritten = 0;
  for (const auto& log : *logs) {
    const auto done = repack(log, documents, options);
    if (!done) report(done.error()), status = exit_impossible;
    rewritten += done && *done ? 1 : 0;
  }
  std::error_code unknown;
  std::string removed;
  if (fs::is_directory(documents, unknown)) {
    const auto unused = remove_unused_documents(documents);
    if (!unused) return report(unused.error()), exit_impossible;
    if (*unused > 0) removed = fmt::format(", {} removed that no log needs", counted(*unused, "document"));
    if (options.whole) fs::remove(documents, unknown);  // where it is empty
  }
  fmt::print("{}: {} of {} rewritten{}\n", path, rewritten, counted(logs->size(), "run log"), removed);
  return status;
}

}  // namespace

int run_pack(const PackOptions& options) {
  int status = exit_done;
  for (const auto& path : options.paths) status = std::max(status, pack(path, options));
  return status;
}

void describe_pack(CLI::App& command, PackOptions& options) {
  command
      .add_option("PATH", options.paths,
                  "run logs, folders of them (*.run.jsonl and *.run.jsonl.gz at any depth), or traces")
      ->required();
  command.add_flag("--whole", options.whole, "put the documents back into the logs");
  auto gzip = std::make_shared<bool>();
  auto* flag =
      command.add_flag("--gzip,!--no-gzip", *gzip,
                       "pack each file with gzip, NAME.gz in place of NAME, or unpack it; the files of a folder "
                       "are its run logs");
  command.footer(
      "The machine, its phrases, its graph, the scene and the list of knowledge files of each log go to a folder\n"
      "documents: the nearest one from the logs upwards, or a new one in the folder given. Documents there that no\n"
      "log needs any more are removed. All commands read all forms, and see the same bytes.\n"
      "Examples: continua pack runs\n"
      "          continua pack runs --gzip\n"
      "          continua pack session.trace.jsonl --gzip\n"
      "          continua pack runs --whole --no-gzip");
  command.callback([&options, gzip, flag] {
    if (flag->count() > 0) options.gzip = *gzip;
  });
}

}  // namespace continua
