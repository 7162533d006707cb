#include "continua/core/scratch_space.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

namespace continua {
namespace fs = std::filesystem;

Result<ScratchSpace> ScratchSpace::make() {
  std::error_code problem;
  auto pattern = (fs::temp_directory_path(problem) / "continua-XXXXXX").string();
  if (problem || !::mkdtemp(pattern.data()))
    return Error{pattern, std::string("no folder can be made: ") + std::strerror(problem ? problem.value() : errno)};
  return ScratchSpace(std::move(pattern));
}

ScratchSpace::~ScratchSpace() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

ScratchSpace::ScratchSpace(ScratchSpace&& other) noexcept : path_(std::exchange(other.path_, {})) {}

ScratchSpace& ScratchSpace::operator=(ScratchSpace&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

}  // namespace continua
