// A session that was live, kept as a regression test.
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct SavedTest {
  std::string trace;
  std::vector<std::string> runs;  ///< approved: of the kinematic world and, where it decides otherwise, of physics
  std::string check;              ///< the command that runs it
};

/// Copies the trace, which may still be written to, into `folder` as `name`, replays it in both worlds, and approves
/// the runs. Errors: it cannot be read, written or replayed, or an expectation is not met; then nothing is left behind.
Result<SavedTest> save_as_test(const std::string& trace_path, const std::string& folder, const std::string& name,
                               const std::string& knowledge);

}  // namespace continua
