// The times of an event, moved.
#pragma once

#include "continua/core/located_json.h"
#include "continua/core/sim_time.h"

namespace continua {

/// The event, as a trace has it, with all its times later by `by`, or earlier: `t`, `happened`, `until` and those of
/// its words.
Json shifted_event(Json event, SimTime by);

}  // namespace continua
