// The subjects of continua check in folders: traces, and files with examples of their own.
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
  data,     ///< phrases, gestures: their possible faults are those that validate tells
};

struct CheckItem {
  std::filesystem::path path;
  ItemKind kind = ItemKind::trace;
  /// Names its folder among those of failures: the file's name without its endings; where several have it, the path's.
  /// No two items of a list have the same.
  std::string name;
};

/// The files and folders that can be checked; folders in the order of the names. Approved runs go with their traces.
/// The error names a path that does not exist.
Result<std::vector<CheckItem>> items_of(const std::vector<std::string>& paths);

}  // namespace continua
