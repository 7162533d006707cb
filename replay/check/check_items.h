// What continua check finds in folders: the files that say something of themselves, and traces.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "continua/core/result.h"

namespace continua {

enum class ItemKind {
  trace,
  machine,
  lexicon,  ///< a folder
  voxemes,  ///< a folder
  data,     ///< phrases, gestures: what can be wrong with them is what validate tells
};

struct CheckItem {
  std::filesystem::path path;
  ItemKind kind = ItemKind::trace;
  /// Names its folder among those of failures: the file's name without its endings; where several have it, the path's.
  /// No two items of a list have the same.
  std::string name;
};

/// What of the files and folders can be checked; folders in the order of the names. Approved runs go with their traces.
/// The error names a path that does not exist.
Result<std::vector<CheckItem>> items_of(const std::vector<std::string>& paths);

}  // namespace continua
