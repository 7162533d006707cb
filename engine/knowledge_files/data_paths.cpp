#include "continua/knowledge_files/data_paths.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {
namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown);
}

std::vector<std::string> names_in(const fs::path& folder, const std::string& extension) {
  std::vector<std::string> names;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

bool is_file(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(path, unknown) && !fs::is_directory(path, unknown);
}

DataPaths data_of_tree(const fs::path& tree) { return {tree / "engine" / "knowledge", tree / "mjcf"}; }

bool is_tree(const fs::path& tree) {
  const auto data = data_of_tree(tree);
  return is_folder(data.knowledge) && is_folder(data.mjcf);
}

std::optional<fs::path> tree_above_program() {
  std::error_code problem;
  auto folder = fs::read_symlink("/proc/self/exe", problem).parent_path();
  if (problem) return std::nullopt;
  for (;; folder = folder.parent_path()) {
    for (const auto& tree : {folder, folder / "share" / "continua"})
      if (is_tree(tree)) return tree;
    if (folder == folder.root_path()) return std::nullopt;
  }
}

Result<std::string> resolve(const std::string& name, const char* what, const fs::path& known,
                            const std::string& extension, const fs::path& folder, const std::string& where) {
  if (name.empty()) return Error{where, fmt::format("no {} is named; expected a name or a path", what)};
  for (const fs::path& path : {known / (name + extension), folder / name, folder / (name + extension), fs::path(name)})
    if (is_file(path)) return path.lexically_normal().string();
  const auto names = names_in(known, extension);
  auto sentence = fmt::format("there is no {} {}{}", what, in_quotes(name), did_you_mean(name, names));
  if (names.empty())
    sentence += fmt::format("; expected a file, or a name in {}", known.lexically_normal().string());
  else
    sentence += fmt::format("; expected a file or one of {}", fmt::join(names, ", "));
  return Error{where, sentence};
}

}  // namespace

Result<DataPaths> data_paths_of(const std::string& tree) {
  if (is_tree(tree)) return data_of_tree(tree);
  return Error{tree, "is no folder of data; expected one with engine/knowledge and mjcf"};
}

Result<DataPaths> find_data_paths(const std::string& knowledge) {
  DataPaths data;
  const char* home = std::getenv("CONTINUA_HOME");
  if (home && *home) {
    if (!is_tree(home))
      return Error{home, "CONTINUA_HOME has no engine/knowledge and mjcf; expected the project's folder"};
    data = data_of_tree(home);
  } else if (const auto tree = tree_above_program()) {
    data = data_of_tree(*tree);
  } else {
    return Error{"", "found no folder with engine/knowledge and mjcf above the program; set CONTINUA_HOME to it"};
  }
  if (!knowledge.empty()) {
    if (!is_folder(knowledge)) return Error{knowledge, "is no folder; expected one with machines, lexicon and voxemes"};
    data.knowledge = knowledge;
  }
  return data;
}

std::string phrases_folder(const DataPaths& data) { return (data.knowledge / "phrases").lexically_normal().string(); }

Result<std::string> resolve_scene(const std::string& name, const DataPaths& data, const fs::path& folder,
                                  const std::string& where) {
  return resolve(name, "scene", data.mjcf / "scenes", ".xml", folder, where);
}

Result<std::string> resolve_machine(const std::string& name, const DataPaths& data, const fs::path& folder,
                                    const std::string& where) {
  return resolve(name, "machine", data.knowledge / "machines", ".json", folder, where);
}

Result<std::string> resolve_gestures(const std::string& name, const DataPaths& data, const std::string& where) {
  return resolve(name, "gesture catalogue", data.knowledge / "gestures", ".json", data.knowledge, where);
}

}  // namespace continua
