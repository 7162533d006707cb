// The log of a live session, followed line by line as it is written.
#pragma once

#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "continua/replay/live/live_session.h"

namespace continua {

class LiveTail {
 public:
  /// From record number `from` on.
  LiveTail(std::shared_ptr<const LiveSession> session, std::uint64_t from);

  /// The lines written since, without their newline, after waiting for them at most so long; a part of them where there
  /// are many.
  std::vector<std::string> next(std::chrono::milliseconds patience);
  /// Number of the record that is next.
  std::uint64_t next_record() const { return next_; }
  /// The state at the last call of `next`.
  const LiveState& state() const { return state_; }
  /// The session has ended and all that is in its log has been read.
  bool is_done() const { return !state_.live && (is_cut_ || read_ >= state_.log_bytes); }

 private:
  const std::shared_ptr<const LiveSession> session_;
  std::ifstream log_;
  std::uint64_t read_ = 0, next_ = 0, from_;
  LiveState state_;
  bool is_cut_ = false;
};

}  // namespace continua
