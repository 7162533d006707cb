// A bar on standard error, where that is a terminal, for long work, with the time that is probably left.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

namespace continua {

/// How far several things are, together. Not safe to use from several threads at once.
class Progress {
 public:
  explicit Progress(std::size_t count);

  /// `done`: 0 … 1.
  void show(std::size_t index, double done);
  /// Takes the bar off the screen until it is shown again.
  void clear();

 private:
  const bool on_terminal_;
  std::vector<double> done_;
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  int shown_percent_ = -1;
};

}  // namespace continua
