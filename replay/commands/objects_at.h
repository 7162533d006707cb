// The places of a trace's objects in mid-time.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// Places of the objects that a replay of the trace has moved before `t`, in the kinematic world. Error: the trace
/// cannot be replayed.
Result<std::vector<std::pair<std::string, ObjectStart>>> objects_at(const std::string& trace, SimTime t);

}  // namespace continua
