// Finds the program's data: knowledge (machines, lexicon, gestures, phrases, voxemes) and MuJoCo models.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct DataPaths {
  std::filesystem::path knowledge;  ///< the folder with machines/, lexicon/, …
  std::filesystem::path mjcf;       ///< the folder with scenes/, objects/, avatar/
};

/// Whether the path is a folder; false if it cannot be examined.
bool is_folder(const std::filesystem::path& path);

/// The names of a folder's files with that extension, without the extension, in order.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& extension);

/// The folder of the phrase files that machines name.
std::string phrases_folder(const DataPaths& data);

/// The data of a tree: a folder with engine/knowledge and mjcf, such as the source tree, or PREFIX/share/continua of an
/// installation. Error: the folder is not a tree.
Result<DataPaths> data_paths_of(const std::string& tree);

/// Finds the data: in the tree CONTINUA_HOME if that is set, else in the nearest tree above the program: a folder, or
/// its share/continua. `knowledge` replaces the knowledge folder unless it is empty. An error names the expected
/// folders.
Result<DataPaths> find_data_paths(const std::string& knowledge = "");

/// The file for a `name` in a trace or an option. In this order: NAME.xml of mjcf/scenes or NAME.json of
/// knowledge/machines, a path relative to `folder` (that of the trace), the path itself. `where`: the error's place.
Result<std::string> resolve_scene(const std::string& name, const DataPaths& data, const std::filesystem::path& folder,
                                  const std::string& where);
Result<std::string> resolve_machine(const std::string& name, const DataPaths& data, const std::filesystem::path& folder,
                                    const std::string& where);
/// The file of gestures for a `name`: NAME.json of knowledge/gestures, or a path.
Result<std::string> resolve_gestures(const std::string& name, const DataPaths& data, const std::string& where);

}  // namespace continua
