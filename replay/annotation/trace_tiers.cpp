// Traces as annotations.
#include "continua/replay/annotation/event_tiers.h"
#include "continua/replay/annotation/run_tiers.h"
#include "continua/replay/media/media_file.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

std::vector<Media> media_of(const Json& header) {
  std::vector<Media> media;
  for (const auto& one : media_in(header)) media.push_back({one.file, one.offset_s});
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
