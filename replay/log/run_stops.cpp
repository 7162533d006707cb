#include "continua/replay/log/run_stops.h"

#include "continua/replay/log/schema.h"

namespace continua {

std::vector<std::uint32_t> records_worth_stopping_at(const RunIndex& run) {
  using log::Stop;
  std::vector<Stop> stops;
  for (const auto& kind : run.kinds()) {
    const auto* known = log::schema_of(kind);
    stops.push_back(known ? known->kind.stop : Stop::always);
  }
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
    if (stop != Stop::never &&
        (!entry.by_sample || stop == Stop::always || (stop == Stop::if_sample_changed_stack && changed)))
      found.push_back(static_cast<std::uint32_t>(n));
  }
  return found;
}

}  // namespace continua
