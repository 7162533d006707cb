// A folder of a program's own, for as long as it needs it.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "continua/core/result.h"
#include "continua/core/scratch_space.h"

namespace continua {

/// Made when it is first asked for, removed with all that is in it when this ends. Safe to use from several threads.
class RunTemporary {
 public:
  /// A new, empty folder of this name in it. REQUIRES a name that was not given before. Errors: it cannot be made.
  Result<std::string> folder(const std::string& name);

 private:
  std::mutex mutex_;
  std::optional<ScratchSpace> all_;
};

}  // namespace continua
