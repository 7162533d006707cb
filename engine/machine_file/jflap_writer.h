// Machines as JFLAP files (.jff): the inverse of jflap.h, for finite and pushdown machines of single characters.
#pragma once

#include <string>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"

namespace continua {

/// The file. A machine with one slot, of type text, becomes a pushdown automaton; its bottom symbol is JFLAP's Z. Of
/// the inputs those of a single character count. A machine that was read from a JFLAP file without chains comes back as
/// it was. Error: the machine has something that JFLAP has not, such as effects, gates or other conditions; it names
/// the state or the transition.
Result<std::string> jflap_of(const Machine& machine);

}  // namespace continua
