#include "continua/replay/log/run_stops.h"

#include <string>

#include "continua/replay/log/records.h"

namespace continua {
namespace {

using log::Stop;

Stop stop_at(const std::string& kind) {
  auto stop = Stop::always;
  log::for_each_kind([&]<class T>() {
    if (T::kind.name == kind) stop = T::kind.stop;
  });
  return stop;
}

}  // namespace

std::vector<std::uint32_t> records_worth_stopping_at(const RunIndex& run) {
  std::vector<Stop> stops;
  for (const auto& kind : run.kinds()) stops.push_back(stop_at(kind));
  std::vector<std::uint32_t> found;
  const auto& marks = run.stack_marks();
  std::size_t mark = 0;
  std::int64_t top = -1;
  for (std::size_t n = 0; n < run.size(); ++n) {
    const auto& entry = run.entry(n);
    bool changed = false;
    if (mark < marks.size() && marks[mark].n == n) {
      changed = marks[mark].top != top;
      top = marks[mark++].top;
    }
    const auto stop = stops[entry.kind];
    const bool of_sample_too = stop == Stop::always || (stop == Stop::if_sample_changed_stack && changed);
    if (stop != Stop::never && (!entry.by_sample || of_sample_too)) found.push_back(static_cast<std::uint32_t>(n));
  }
  return found;
}

}  // namespace continua
