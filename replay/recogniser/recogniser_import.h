// Outputs of several recognisers as one trace.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/recogniser/camera.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// One trace of all files, in order of time; of one time in the order of the files. A format for each file, or one for
/// all. `camera`: that of recognisers of hands, or null. Times since 1970 become times since the first event. Errors: a
/// file is no such output, an event is none of a trace, or nothing was recognised.
Result<Trace> trace_of_recognisers(const std::vector<std::string>& files, const std::vector<std::string>& formats,
                                   std::shared_ptr<const Camera> camera = {});

}  // namespace continua
