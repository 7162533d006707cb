// Rules of a machine that can be set without changing its file: for a recording, or to try what they do (FORMAT.md,
// Parameters).
#pragma once

#include <string>
#include <string_view>

#include "automaton/machine.h"
#include "core/located_json.h"
#include "core/result.h"

namespace continua {

/// The value of every parameter, {name: value}, as it is set now.
Json parameter_values(const Machine& machine);

/// The value that every parameter had when something was recorded: the one of the earliest `until` after that time,
/// else the file's own. `recorded` is a time as in 2018-02-05T13:53:17.
Json parameter_values_at(const Machine& machine, std::string_view recorded);

/// Sets those that `values`, {name: value}, names. Errors, at `where`: there is none of that name, or its values are of
/// another kind.
Outcome set_parameters(Machine& machine, const Json& values, const std::string& where);

}  // namespace continua
