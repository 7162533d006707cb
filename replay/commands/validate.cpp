#include "continua/replay/commands/validate.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/gzip_text.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/check/file_kinds.h"

namespace continua {
namespace {

int validate(const std::string& path);

int validate_folder(const std::string& folder) {
  constexpr std::array<std::string_view, 5> extensions = {".xml", ".json", ".jsonl", ".jsonl.gz", ".jff"};
  std::vector<std::string> files;
  std::error_code problem;
  for (std::filesystem::recursive_directory_iterator each(folder, problem), end; !problem && each != end;
       each.increment(problem))
    if (std::any_of(extensions.begin(), extensions.end(),
                    [&](std::string_view one) { return each->path().string().ends_with(one); }) &&
        !is_folder(each->path()))
      files.push_back(each->path().lexically_normal().string());
  if (problem) return report({folder, "cannot be read to its end: " + problem.message()}), exit_impossible;
  if (files.empty())
    return report({folder, fmt::format("has no file to validate; expected {}", fmt::join(extensions, ", "))}),
           exit_impossible;
  std::sort(files.begin(), files.end());
  int status = exit_done;
  for (const auto& file : files) status = std::max(status, validate(file));
  return status;
}

// Of a folder, the files that may be the project's.
int validate(const std::string& path) {
  if (is_folder(path)) return validate_folder(path);
  const auto text = read_text(path);
  if (!text) return report(text.error()), exit_impossible;
  const auto check = check_file(*text, path);
  for (const auto& problem : check.problems) put(stderr, printable_line(problem.text()) + "\n");
  for (const auto& note : check.notes) put(stderr, printable_line(note) + " (note)\n");
  if (!check.problems.empty()) return check.status;
  fmt::print("{}\n", printable_line(path + ": " + check.summary));
  return exit_done;
}

}  // namespace

int run_validate(const ValidateOptions& options) {
  int status = exit_done;
  for (const auto& file : options.files) status = std::max(status, validate(file));
  return status;
}

void describe_validate(CLI::App& command, ValidateOptions& options) {
  command.add_option("FILE", options.files, "files of any kind, or folders of them")->required();
  command.footer("Example: continua validate traces/corner/*.trace.jsonl");
}

}  // namespace continua
