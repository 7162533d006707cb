// Where the program's data is: knowledge (machines, lexicon, gestures, phrases, voxemes) and MuJoCo models.
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

/// False also where the path cannot be looked at.
bool is_folder(const std::filesystem::path& path);

/// The names that a folder offers, in order: its files with that extension, without it.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& extension);

/// Of the files that machines name as their phrases.
std::string phrases_folder(const DataPaths& data);

/// The data of a tree: a folder with engine/knowledge and mjcf, such as the source tree, or PREFIX/share/continua of an
/// installation. The error says that it has none.
Result<DataPaths> data_paths_of(const std::string& tree);

/// Finds the data without being told: in the tree CONTINUA_HOME if that is set, else in the nearest tree above the
/// program (a folder, or its share/continua), else in the tree from which the program was built. `knowledge`
/// replaces the knowledge folder unless it is empty. An error names the places.
Result<DataPaths> find_data_paths(const std::string& knowledge = "");

/// The file that a trace or an option means by `name`: NAME.xml of mjcf/scenes or NAME.json of knowledge/machines, a
/// path relative to `folder` (the trace's own), or a path as it stands, in this order. `where` is the error's place.
Result<std::string> resolve_scene(const std::string& name, const DataPaths& data, const std::filesystem::path& folder,
                                  const std::string& where);
Result<std::string> resolve_machine(const std::string& name, const DataPaths& data, const std::filesystem::path& folder,
                                    const std::string& where);
/// Likewise NAME.json of knowledge/gestures, or a path.
Result<std::string> resolve_gestures(const std::string& name, const DataPaths& data, const std::string& where);

}  // namespace continua
