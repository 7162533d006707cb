#include "continua/replay/live/live_audience.h"

namespace continua {

void LiveAudience::tell(const std::function<void(LiveState&)>& change) {
  const std::lock_guard lock(mutex_);
  const bool ran = state_.clock.runs(), was_live = state_.live;
  const auto bytes = state_.log_bytes;
  change(state_);
  const bool changed = ran != state_.clock.runs() || was_live != state_.live;
  if (changed) ++state_.changes;
  if (changed || bytes != state_.log_bytes) wake();
}

void LiveAudience::wake() {
  changed_.notify_all();
  if (wake_) wake_();
}

void LiveAudience::wake_by(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
}

LiveState LiveAudience::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

LiveState LiveAudience::wait(const LiveState& known, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience,
                    [&] { return state_.log_bytes != known.log_bytes || state_.changes != known.changes; });
  return state_;
}

void LiveAudience::attend(bool is_recorder, int more) {
  const std::lock_guard lock(mutex_);
  (is_recorder ? recorders_ : viewers_) += more;
  ++state_.changes;
  wake();
}

int LiveAudience::viewers() const {
  const std::lock_guard lock(mutex_);
  return viewers_;
}

bool LiveAudience::is_present() const {
  const std::lock_guard lock(mutex_);
  return viewers_ + recorders_ > 0;
}

}  // namespace continua
