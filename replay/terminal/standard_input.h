// "-" in place of a file's name.
#pragma once

#include <optional>
#include <string>

#include "continua/core/result.h"
#include "continua/core/scratch_space.h"

namespace continua {

/// Standard input as a file, since commands read their files more than once and out of order.
class StandardInput {
 public:
  /// The file with all that comes until the input ends; it goes with this. Its name begins with "stdin" and ends as its
  /// first line says: .trace.jsonl for a trace, .run.jsonl for a run log. Errors: it was asked for before; it cannot be
  /// read or kept.
  Result<std::string> file();

 private:
  std::optional<ScratchSpace> folder_;
};

}  // namespace continua
