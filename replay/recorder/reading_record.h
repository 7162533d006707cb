// The `reading` record of a run log: what an input was taken to mean (RUNLOG.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/moves/move.h"

namespace continua {

/// Names of the objects that the move's noun phrase or pointing can mean, the likeliest first; nullopt if it has none.
std::optional<std::vector<std::string>> referents_of(const Move& move);

/// The fields of the record. `because`: numbers of the records that the move draws on.
Json reading_fields(const Move& move, Json because);

}  // namespace continua
