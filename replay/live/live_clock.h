// Engine time as wall time goes on.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "continua/core/sim_time.h"

namespace continua {

using WallTime = std::chrono::steady_clock::time_point;

/// Stands still at first. A value; who reads it says how late it is.
class LiveClock {
 public:
  /// `speed`: seconds of engine time in one of wall time.
  explicit LiveClock(double speed = 1) : speed_(speed) {}

  bool runs() const { return since_.has_value(); }
  double speed() const { return speed_; }

  SimTime at(WallTime now) const {
    if (!since_) return t_;
    const std::chrono::duration<double> passed = std::max(now, *since_) - *since_;
    return t_ + SimTime::from_seconds(passed.count() * speed_);
  }
  /// When it will show `t`, if it runs on.
  WallTime when(SimTime t) const {
    const std::chrono::duration<double> left((t - t_).seconds() / speed_);
    return since_.value_or(WallTime()) + std::chrono::duration_cast<WallTime::duration>(left);
  }

  void run(WallTime now) {
    t_ = at(now);
    since_ = now;
  }
  void stop(WallTime now) {
    t_ = at(now);
    since_.reset();
  }
  /// Shows `t` now, running or not.
  void set(SimTime t, WallTime now) {
    t_ = t;
    if (since_) since_ = now;
  }

 private:
  double speed_;
  SimTime t_;                      // at since_
  std::optional<WallTime> since_;  // none: it stands still
};

}  // namespace continua
