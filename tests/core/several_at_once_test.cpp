#include "continua/core/several_at_once.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "support/catch.h"

using namespace continua;

TEST_CASE("each piece of work is done once") {
  for (const int jobs : {-1, 0, 1, 2, 7}) {
    std::vector<std::atomic<int>> done(23);
    several_at_once(done.size(), jobs, [&](std::size_t i) { ++done[i]; });
    CHECK(std::all_of(done.begin(), done.end(), [](const auto& times) { return times == 1; }));
  }
  several_at_once(0, 4, [](std::size_t) { FAIL("there is no work"); });
}

TEST_CASE("one piece at a time is done by the caller, in the order of the numbers") {
  std::vector<std::size_t> order;
  bool by_caller = true;
  several_at_once(5, 1, [&, caller = std::this_thread::get_id()](std::size_t i) {
    order.push_back(i);
    by_caller = by_caller && std::this_thread::get_id() == caller;
  });
  CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(by_caller);
}

TEST_CASE("as many pieces are under way as there are jobs") {
  // Each waits for the two others of its three: it would wait for ever if fewer were under way.
  std::barrier<> together(3);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  several_at_once(6, 3, [&](std::size_t) {
    together.arrive_and_wait();
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  CHECK(threads.size() == 3);
}
