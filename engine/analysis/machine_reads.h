// Inputs of a machine's terms from outside the automaton.
#pragma once

#include <optional>
#include <string>

#include "continua/automaton/machine.h"

namespace continua {

/// Something besides input symbols, stack and registers that the machine's decisions depend on: "'clear', a fact of the
/// world", "'target', which inputs carry". Nothing if they depend on no such thing.
std::optional<std::string> reads_from_outside(const Machine& machine);

}  // namespace continua
