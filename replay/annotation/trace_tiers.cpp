// Traces as annotations.
#include "continua/replay/annotation/event_tiers.h"
#include "continua/replay/annotation/run_tiers.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

std::vector<Media> media_of(const Json& header) {
  std::vector<Media> media;
  const auto& listed = member_of(header, "media");
  if (!listed.is_array()) return media;
  for (const auto& one : listed) {
    const auto& offset = member_of(one, "offset");
    if (const auto file = text_of(one, "file"); !file.empty())
      media.push_back({file, offset.is_number() ? offset.get<double>() : 0});
  }
  return media;
}

}  // namespace

Annotations annotations_of_trace(const Trace& trace) {
  TierMaker tiers;
  EventTiers events(tiers);
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    const auto line = trace.events[i].line > 0 ? trace.events[i].line : i + 2;
    events.add(line, line, json_of(trace.events[i]));
  }
  const auto last = trace.events.empty() ? SimTime{} : trace.events.back().t;
  return {trace.name,     trace.header.recorded, write_header(trace.header), media_of(trace.header.json),
          tiers.finish(), milliseconds(last)};
}

}  // namespace continua
