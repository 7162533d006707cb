// The sentence about a name under which a machine has no value that can be set.
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/machine.h"

namespace continua {

/// "the machine m has no value 'gate.A' that can be set: the state 'A' has no gate (did you mean 'gate.B'?)". `names`:
/// those that it has; the nearest of the same kind is named, however far it is.
std::string unknown_setting(const Machine& machine, const std::string& name, const std::vector<std::string>& names);

}  // namespace continua
