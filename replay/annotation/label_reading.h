// Labels that people wrote, as members of events: the inverse of label_of_event().
#pragma once

#include <string>

#include "continua/core/result.h"
#include "continua/replay/annotation/tier_map.h"

namespace continua {

/// The members that the label tells, without `t` and `kind`. Error: it tells none; the thing found and expected.
Result<Json> read_label(const std::string& label, const TierUse& use);

}  // namespace continua
