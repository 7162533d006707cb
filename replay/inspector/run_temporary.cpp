#include "continua/replay/inspector/run_temporary.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace continua {

namespace fs = std::filesystem;

RunTemporary::~RunTemporary() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Result<std::string> RunTemporary::folder(const std::string& name) {
  const std::lock_guard lock(mutex_);
  std::error_code problem;
  if (path_.empty()) {
    auto pattern = (fs::temp_directory_path(problem) / "continua-XXXXXX").string();
    if (problem || !::mkdtemp(pattern.data()))
      return Error{pattern, std::string("no folder can be made: ") + std::strerror(errno)};
    path_ = pattern;
  }
  const auto folder = path_ / name;
  fs::create_directory(folder, problem);
  if (problem) return Error{folder.string(), "no folder can be made: " + problem.message()};
  return folder.string();
}

}  // namespace continua
