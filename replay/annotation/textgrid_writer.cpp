#include <fmt/format.h>

#include <algorithm>

#include "continua/replay/annotation/textgrid.h"

namespace continua {
namespace {

std::string in_seconds(std::int64_t ms) { return fmt::format("{}", static_cast<double>(ms) / 1000); }

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

struct Interval {
  std::int64_t begin_ms = 0, end_ms = 0;
  std::string label;
};

// The whole time in intervals.
std::vector<Interval> intervals_of(const Tier& tier, std::int64_t end_ms, bool events) {
  std::vector<Interval> intervals;
  std::int64_t reached = 0;
  const auto fill = [&](std::int64_t until) {
    if (until > reached) intervals.push_back({reached, until, ""});
  };
  for (const auto& each : tier.annotations) {
    fill(each.begin_ms);
    intervals.push_back(
        {each.begin_ms, each.end_ms, events ? each.event.is_null() ? "" : compact(each.event) : each.value});
    reached = each.end_ms;
  }
  fill(end_ms);
  return intervals;
}

}  // namespace

std::string textgrid_of(const Annotations& annotations) {
  std::int64_t end_ms = std::max<std::int64_t>(annotations.end_ms, 1);
  std::vector<std::pair<const Tier*, bool>> rows;
  for (const auto& tier : annotations.tiers) {
    if (!tier.annotations.empty()) end_ms = std::max(end_ms, tier.annotations.back().end_ms);
    rows.emplace_back(&tier, false);
    if (std::any_of(tier.annotations.begin(), tier.annotations.end(), [](const auto& a) { return !a.event.is_null(); }))
      rows.emplace_back(&tier, true);
  }
  const Tier header{"continua.trace", "", {{0, 0, end_ms, annotations.header}}};
  if (!annotations.header.empty()) rows.emplace_back(&header, false);
  std::string out = fmt::format(
      "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\nxmin = 0\nxmax = {}\ntiers? <exists>\nsize = {}\n"
      "item []:\n",
      in_seconds(end_ms), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [tier, events] = rows[i];
    const auto intervals = intervals_of(*tier, end_ms, events);
    out += fmt::format(
        "    item [{}]:\n        class = \"IntervalTier\"\n        name = {}\n        xmin = 0\n        xmax = {}\n"
        "        intervals: size = {}\n",
        i + 1, quoted(tier->name + (events ? events_ending : "")), in_seconds(end_ms), intervals.size());
    for (std::size_t k = 0; k < intervals.size(); ++k)
      out += fmt::format(
          "        intervals [{}]:\n            xmin = {}\n            xmax = {}\n            text = {}\n", k + 1,
          in_seconds(intervals[k].begin_ms), in_seconds(intervals[k].end_ms), quoted(intervals[k].label));
  }
  return out;
}

}  // namespace continua
