#include "continua/replay/log/run_stops.h"

#include <set>
#include <string>

namespace continua {
namespace {

enum class Stop { never, unless_of_sample, of_sample_too, of_sample_if_stack_changed };

Stop stop_at(const std::string& kind) {
  static const std::set<std::string> never{"run",    "symbol", "rest",     "end", "memory",
                                           "belief", "block",  "observed", "pose"};
  if (never.count(kind)) return Stop::never;
  if (kind == "input" || kind == "refusal") return Stop::unless_of_sample;
  return kind == "transition" || kind == "rewrite" ? Stop::of_sample_if_stack_changed : Stop::of_sample_too;
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
    if (stop != Stop::never &&
        (!entry.by_sample || stop == Stop::of_sample_too || (stop == Stop::of_sample_if_stack_changed && changed)))
      found.push_back(static_cast<std::uint32_t>(n));
  }
  return found;
}

}  // namespace continua
