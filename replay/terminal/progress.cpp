#include "continua/replay/terminal/progress.h"

#include <unistd.h>

#include <cstdio>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "continua/replay/terminal/terminal.h"

namespace continua {

namespace {

constexpr double earliest_guess_s = 2;  // before, too little is known of the time that the rest takes
constexpr std::size_t columns = 79;

// ", 2:05 left".
std::string time_left(double done, double elapsed_s) {
  if (done <= 0 || done >= 1 || elapsed_s < earliest_guess_s) return "";
  const auto seconds = static_cast<long>(elapsed_s * (1 - done) / done + 0.5);
  return fmt::format(", {}:{:02} left", seconds / 60, seconds % 60);
}

}  // namespace

Progress::Progress(std::size_t count) : on_terminal_(isatty(STDERR_FILENO) != 0), done_(count, 0.0) {}

void Progress::show(std::size_t index, double done) {
  done_[index] = done;
  if (!on_terminal_) return;
  const double total = std::accumulate(done_.begin(), done_.end(), 0.0);
  const double part = total / static_cast<double>(done_.size());
  const int percent = static_cast<int>(100 * part);
  if (percent == shown_percent_) return;
  shown_percent_ = percent;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begun_;
  const auto bar = fmt::format("[{:<40}] {:3} %{}", std::string(static_cast<std::size_t>(percent * 2 / 5), '='),
                               percent, time_left(part, elapsed.count()));
  put(stderr, fmt::format("\r{:<{}}", bar, columns));
  std::fflush(stderr);
}

void Progress::clear() {
  if (shown_percent_ >= 0) put(stderr, fmt::format("\r{:{}}\r", "", columns));
  shown_percent_ = -1;
}

}  // namespace continua
