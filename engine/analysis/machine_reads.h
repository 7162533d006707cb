// What a machine's terms read.
#pragma once

#include <optional>
#include <string>

#include "automaton/machine.h"

namespace continua {

/// Something beside input symbols, stack and registers that decides what the machine does: "'clear', a fact of the
/// world", "'target', which inputs carry". Nothing if there is none.
std::optional<std::string> reads_from_outside(const Machine& machine);

}  // namespace continua
