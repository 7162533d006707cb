// Values of a machine that are set from outside, in a trace's header or on the command line (FORMAT.md, Parameters):
//
//   NAME                   a parameter
//   weights.ID             the weight of a transition
//   gate.STATE             the number in the condition of a state's gate, where there is one alone
//   belief.ROW.LEVEL       a level of a row of the evidence, both counted from 1
//   belief.overheard       how sure it makes to hear the avatar's own words
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// The names of all values of the machine that can be set, parameters first.
std::vector<std::string> names_of_settings(const Machine& machine);

/// Sets the values that `values`, {name: value}, names, in the machine and, but for parameters, in its document.
/// Errors, at `where`: the machine has no value of that name, or the value is of another kind or out of bounds.
Outcome apply_settings(Machine& machine, const Json& values, const std::string& where);

/// Name and value of the text NAME=VALUE. A value that is no JSON is a text. Errors, at `where`: there is no name or no
/// sign of equality.
Result<std::pair<std::string, Json>> read_setting(const std::string& text, const std::string& where);

}  // namespace continua
