// Outputs of several recognisers as one trace.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// One trace of all files, in order of time; of one time in the order of the files. A format for each file, or one for
/// all. `common`: what all of them share, besides their names. Times since 1970 become times since the first event.
/// Errors: a file is no such output, an event is none of a trace, or nothing was recognised.
Result<Trace> trace_of_recognisers(const std::vector<std::string>& files, const std::vector<std::string>& formats,
                                   OutputSource common = {});

/// The trace with these events, in JSON, in order of time; calendar times become times since the first. REQUIRES that
/// each has a number `t`. Error: an event is none of a trace.
Result<Trace> with_events(Trace trace, std::vector<Json> events);

}  // namespace continua
