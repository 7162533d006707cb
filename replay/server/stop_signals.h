// Commands that serve until they are told to stop.
#pragma once

#include <csignal>
#include <functional>
#include <thread>

namespace continua {

/// Calls `stop` once, on a thread of its own, when the program is told to stop (SIGINT, SIGTERM, SIGHUP). Those signals
/// are taken by that thread alone, so that stopping needs nothing a signal handler may not do: REQUIRES that no other
/// thread has been started yet.
class StopSignals {
 public:
  explicit StopSignals(std::function<void()> stop);
  /// Waits for a `stop` that is under way.
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

 private:
  sigset_t signals_;
  std::thread waiting_;
};

}  // namespace continua
