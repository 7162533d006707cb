// Many pieces of work, several of them at a time.
#pragma once

#include <cstddef>
#include <functional>

namespace continua {

/// Calls `work(i)` for each `i` below `count`, in the order of the numbers, as many at a time as `jobs` says (at least
/// one), and returns when all are done. One of the threads is the caller's. `work` must not throw.
void several_at_once(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace continua
