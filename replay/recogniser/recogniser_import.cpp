#include "continua/replay/recogniser/recogniser_import.h"

#include <fmt/format.h>

#include <algorithm>

#include "continua/core/digest.h"
#include "continua/replay/trace/event_shift.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {

Result<Trace> trace_of_recognisers(const std::vector<std::string>& files, const std::vector<std::string>& formats,
                                   OutputSource common) {
  if (formats.size() != 1 && formats.size() != files.size())
    return Error{"--from", fmt::format("found {} formats for {} files; expected one, or one for each", formats.size(),
                                       files.size())};
  std::vector<Json> events;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto text = read_file(files[i]);
    if (!text) return text.error();
    common.name = files[i];
    const auto read = read_output(*recogniser_format(formats[formats.size() == 1 ? 0 : i]), *text, common);
    if (!read) return read.error();
    events.insert(events.end(), read->begin(), read->end());
  }
  if (events.empty()) return Error{files.front(), "nothing was recognised"};
  Trace trace;
  trace.name = files.front();
  return with_events(std::move(trace), std::move(events));
}

Result<Trace> with_events(Trace trace, std::vector<Json> events) {
  const auto time_of = [](const Json& event) { return event["t"].get<double>(); };
  std::stable_sort(events.begin(), events.end(), [&](const Json& a, const Json& b) { return time_of(a) < time_of(b); });
  const double first = events.empty() ? 0 : time_of(events.front());
  for (auto& event : events) {
    if (first >= least_calendar_s) event = shifted_event(std::move(event), SimTime{} - SimTime::from_seconds(first));
    std::vector<Error> problems;
    trace.events.push_back(
        event_from_json(std::move(event), trace.name, trace.events.size() + 2, problems, trace.notes));
    if (!problems.empty()) return problems.front();
  }
  trace.digest = digest(write_trace(trace));
  return trace;
}

}  // namespace continua
