#include "continua/core/several_at_once.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace continua {

void several_at_once(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> others;
  const auto threads = std::min(count, static_cast<std::size_t>(std::max(jobs, 1)));
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back(take_turns);
  take_turns();
  for (auto& thread : others) thread.join();
}

}  // namespace continua
