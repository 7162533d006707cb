// Room for files that nobody keeps.
#pragma once

#include <filesystem>

#include "continua/core/result.h"

namespace continua {

/// A folder of its own among the system's temporary ones. It goes with this, with all that is in it.
class ScratchSpace {
 public:
  /// The error names the folder that cannot be made.
  static Result<ScratchSpace> make();
  ~ScratchSpace();
  ScratchSpace(ScratchSpace&& other) noexcept;
  ScratchSpace& operator=(ScratchSpace&& other) noexcept;

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit ScratchSpace(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;  ///< empty: there is none
};

}  // namespace continua
