// A live session as others see it: its latest state, and the number of those who listen. Safe to use from several
// threads; nobody waits for the engine.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/live/live_clock.h"
#include "continua/replay/live/live_events.h"

namespace continua {

/// The state of a session at a moment.
struct LiveState {
  bool live = true;
  std::optional<LiveTiming> timing;
  LiveClock clock;
  SimTime t;                  ///< as far as the engine has come
  std::string machine_state;  ///< the state of the machine
  std::uint64_t log_bytes = 0;
  int changes = 0;             ///< counts changes that a viewer is told of besides the log: pauses, viewers, the end
  std::optional<Error> broke;  ///< why it ended, if not because it was told to
};

class LiveAudience {
 public:
  /// Changes the state and wakes all who wait if there is more to tell.
  void tell(const std::function<void(LiveState&)>& change);

  LiveState state() const;
  /// Waits until there is more to tell than in `known`, at most so long.
  LiveState wait(const LiveState& known, std::chrono::milliseconds patience) const;

  /// Calls this as well wherever those who wait are woken; it must neither block nor ask this object.
  void wake_by(std::function<void()> wake);

  /// The one that records the session, or somebody else, listens from now on (`more` 1) or has gone (-1).
  void attend(bool is_recorder, int more);
  /// The listeners, without the one that records the session.
  int viewers() const;
  /// Whether anybody listens.
  bool is_present() const;

 private:
  void wake();

  mutable std::mutex mutex_;  // guards the members below
  mutable std::condition_variable changed_;
  std::function<void()> wake_;
  LiveState state_;
  int viewers_ = 0, recorders_ = 0;
};

}  // namespace continua
