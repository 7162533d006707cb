// Inputs of a machine's terms from outside the automaton.
#pragma once

#include <optional>
#include <string>

#include "continua/automaton/machine.h"

namespace continua {

/// A source besides input symbols, stack and registers that the machine's decisions depend on: "'clear', a fact of the
/// world", "'target', which inputs carry". Nothing if there is no such source.
std::optional<std::string> reads_from_outside(const Machine& machine);

}  // namespace continua
