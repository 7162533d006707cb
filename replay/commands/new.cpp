#include "continua/replay/commands/new.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/check/run_check.h"
#include "continua/replay/session/live_setup.h"
#include "continua/replay/terminal/shell_word.h"
#include "continua/simulation/scene.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

// The folder of the knowledge with the files of a project. Their names and those of their folders end in ".in" where
// they would be taken for knowledge otherwise.
constexpr const char* template_name = "project";
constexpr std::string_view template_ending = ".in";

Outcome write(const fs::path& path, const std::string& content) {
  std::error_code problem;
  fs::create_directories(path.parent_path(), problem);
  if (problem) return Error{path.parent_path().string(), "cannot be made: " + problem.message()};
  return replace_file(path.string(), content);
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (fs::recursive_directory_iterator each(folder, problem), end; !problem && each != end; each.increment(problem))
    if (!is_folder(each->path())) files.push_back(each->path());
  std::sort(files.begin(), files.end());
  return files;
}

// The path without the ending of each of its parts.
fs::path named(const fs::path& path) {
  fs::path plain;
  for (const auto& part : path) plain /= part.extension() == template_ending ? part.stem() : part;
  return plain;
}

std::string with(std::string text, std::string_view mark, const std::string& value) {
  for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size()))
    text.replace(at, mark.size(), value);
  return text;
}

// Copies a part of the template into `to`, its marks replaced.
Outcome fill(const fs::path& from, const fs::path& to, const NewOptions& options) {
  const auto files = files_below(from);
  if (files.empty()) return Error{from.string(), "has no file; expected those of a new project"};
  const auto name = fs::path(options.folder).filename().string();
  for (const auto& file : files) {
    auto text = read_file(file.string());
    if (!text) return text.error();
    text = with(with(*text, "@NAME@", name), "@OPTIONS@", options.own_knowledge ? " --knowledge knowledge" : "");
    if (auto problem = write(to / named(file.lexically_relative(from)), *text)) return problem;
  }
  return std::nullopt;
}

Outcome copy_knowledge(const DataPaths& data, const NewOptions& options) {
  const fs::path to = fs::path(options.folder) / "knowledge";
  for (const auto& file : files_below(data.knowledge)) {
    const auto inside = file.lexically_relative(data.knowledge);
    if (*inside.begin() == template_name) continue;
    const auto text = read_file(file.string());
    if (!text) return text.error();
    if (auto problem = write(to / inside, *text)) return problem;
  }
  return std::nullopt;
}

// The scene with all that it includes, so that it stands by itself.
Outcome write_scene(const DataPaths& data, const NewOptions& options) {
  auto name = options.scene;
  if (name.empty()) {
    const auto setup = live_setup(data);
    if (!setup) return setup.error();
    name = setup->value("scene", "");
  }
  const auto path = resolve_scene(name, data, ".", "--scene");
  if (!path) return path.error();
  const auto scene = load_scene(*path);
  if (!scene) return scene.error();
  return write(fs::path(options.folder) / "scenes" / "table.xml", scene->text());
}

Outcome make(const NewOptions& options) {
  std::error_code unknown;
  const auto name = fs::path(options.folder).filename().string();
  if (name.empty() || name.find_first_of("\"\\\n") != std::string::npos)
    return Error{options.folder, "is no name; expected one for a folder, without quotation marks"};
  if (fs::exists(options.folder, unknown))
    return Error{options.folder, "exists already; expected the name of a new folder"};
  const auto data = find_data_paths();
  if (!data) return data.error();
  if (auto problem = write_scene(*data, options)) return problem;
  if (auto problem = fill(data->knowledge / template_name, options.folder, options)) return problem;
  return options.own_knowledge ? copy_knowledge(*data, options) : std::nullopt;
}

// Approves the runs without physics, then holds both worlds against them.
int check_all(const NewOptions& options) {
  const fs::path folder = options.folder;
  std::error_code unknown;
  fs::create_directories(folder / "traces" / "documents", unknown);
  CheckOptions check;
  check.paths = {(folder / "traces").string()};
  if (options.own_knowledge) check.knowledge = (folder / "knowledge").string();
  check.approve = check.yes = true;
  if (const int status = run_check(check); status != exit_done) return status;
  check.approve = check.yes = false;
  check.physics = true;
  return run_check(check);
}

}  // namespace

int run_new(const NewOptions& options) {
  if (const auto problem = make(options)) return report(*problem), exit_impossible;
  if (const int status = check_all(options); status != exit_done) return status;
  fmt::print("{} is ready: cd {}, and see README.md\n", printable_line(options.folder), shell_word(options.folder));
  return exit_done;
}

void describe_new(CLI::App& command, NewOptions& options) {
  command.add_option("FOLDER", options.folder, "its name; the folder must not be there yet")->required();
  command.add_option("--scene", options.scene, "a name or an MJCF file; otherwise that of knowledge/live.json");
  command.add_flag("--own-knowledge", options.own_knowledge,
                   "a copy of machines, lexicon, phrases and voxemes too, to change");
  command.footer(
      "Makes a project: a trace with its approved run, a machine based on another, a scene, a page that tells what\n"
      "to do next, and a workflow for GitHub; and checks it.\n"
      "Exit status: 0 the project's check passes, 1 it does not (the trace is for the usual scene), 2 it cannot be "
      "made.\n"
      "Examples: continua new my_study\n"
      "          continua new my_study --own-knowledge");
}

}  // namespace continua
