#include "continua/replay/live/live_tail.h"

#include <algorithm>

namespace continua {
namespace {

constexpr std::uint64_t most_bytes = 1 << 20;  // bytes

}  // namespace

LiveTail::LiveTail(std::shared_ptr<const LiveSession> session, std::uint64_t from)
    : session_(std::move(session)), log_(session_->setting().options.log_path, std::ios::binary), from_(from) {}

std::vector<std::string> LiveTail::next(std::chrono::milliseconds patience) {
  // A log that was cut meanwhile has no more, whatever was announced.
  state_ =
      read_ < state_.log_bytes && !is_cut_ ? session_->audience().state() : session_->audience().wait(state_, patience);
  std::vector<std::string> lines;
  // The announced bytes are whole lines.
  for (const auto most = read_ + most_bytes; read_ < std::min(state_.log_bytes, most);) {
    std::string line;
    if (!std::getline(log_, line)) {
      log_.clear();
      is_cut_ = !state_.live;
      break;
    }
    read_ += line.size() + 1;
    if (next_++ >= from_) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace continua
