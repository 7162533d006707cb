// Pictures of runs, for those that ask for them without knowing how they are drawn.
#pragma once

#include <memory>
#include <string>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Safe to use from several threads.
class RunFrames {
 public:
  virtual ~RunFrames() = default;

  /// Why no picture can be drawn on this machine; nothing if they can.
  virtual Outcome unavailable() = 0;
  /// The fault of `size`, "WxH" in pixels or empty; nothing if it can be drawn.
  virtual Outcome wrong_size(const std::string& size) = 0;
  /// The run's scene at `t` as PNG. REQUIRES neither of the above, and 0 ≤ t ≤ the run's end. Errors: this log's scene
  /// cannot be drawn.
  virtual Result<std::string> png(const std::shared_ptr<const RunIndex>& run, SimTime t, const std::string& size) = 0;
};

}  // namespace continua
