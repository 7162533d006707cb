#include "continua/replay/inspector/run_temporary.h"

#include <filesystem>
#include <system_error>
#include <utility>

namespace continua {

namespace fs = std::filesystem;

Result<std::string> RunTemporary::folder(const std::string& name) {
  const std::lock_guard lock(mutex_);
  if (!all_) {
    auto all = ScratchSpace::make();
    if (!all) return all.error();
    all_ = std::move(*all);
  }
  const auto folder = all_->path() / name;
  std::error_code problem;
  fs::create_directory(folder, problem);
  if (problem) return Error{folder.string(), "no folder can be made: " + problem.message()};
  return folder.string();
}

}  // namespace continua
