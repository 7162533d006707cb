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

/// Also where the path cannot be looked at: then it is none.
bool is_folder(const std::filesystem::path& path);

/// The names that a folder offers, in order: its files with that extension, without it.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& extension);

/// Of the files that machines name as their phrases.
std::string phrases_folder(const DataPaths& data);

/// Finds the data without being told: under CONTINUA_HOME (a source tree) if that is set, else in the nearest folder
/// above the program that holds engine/knowledge and mjcf, else in the tree the program was built from. `knowledge`
/// replaces the knowledge folder unless it is empty. An error names what was looked for.
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
