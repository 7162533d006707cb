// Parameters of a machine: values that can be set without a change of the machine's file, for a recording or to try
// their effect (FORMAT.md, Parameters).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

class Item;
class TermReader;

/// The machine file's `parameters`; each name becomes known to the terms.
std::vector<Parameter> read_parameters(const Item& item, TermReader& terms);

/// The current value of every parameter, {name: value}.
Json parameter_values(const Machine& machine);

/// The value of every parameter at the time of a recording: the value of the earliest `until` after that time, else the
/// file's own. `recorded`: a time such as 2018-02-05T13:53:17.
Json parameter_values_at(const Machine& machine, std::string_view recorded);

/// Sets the parameters that `values`, {name: value}, names. Errors, at `where`: the machine has no parameter of that
/// name, or the parameter's values are of another kind.
Outcome set_parameters(Machine& machine, const Json& values, const std::string& where);

}  // namespace continua
