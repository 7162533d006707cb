#include "continua/replay/terminal/progress.h"

#include <unistd.h>

#include <cstdio>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "continua/replay/terminal/terminal.h"

namespace continua {

Progress::Progress(std::size_t count) : on_terminal_(isatty(STDERR_FILENO) != 0), done_(count, 0.0) {}

void Progress::show(std::size_t index, double done) {
  done_[index] = done;
  if (!on_terminal_) return;
  const double total = std::accumulate(done_.begin(), done_.end(), 0.0);
  const int percent = static_cast<int>(100 * total / static_cast<double>(done_.size()));
  if (percent == shown_percent_) return;
  shown_percent_ = percent;
  put(stderr, fmt::format("\r[{:<40}] {:3} %", std::string(static_cast<std::size_t>(percent * 2 / 5), '='), percent));
  std::fflush(stderr);
}

void Progress::clear() {
  if (shown_percent_ >= 0) put(stderr, fmt::format("\r{:60}\r", ""));
  shown_percent_ = -1;
}

}  // namespace continua
