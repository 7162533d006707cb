// What `continua machine` tells about a machine, as text.
#pragma once

#include <memory>
#include <string>

#include "automaton/machine.h"

namespace continua {

/// Class, size, conflicts with their witnesses, unreachable states, dead ends, transitions that never fire, ε-cycles
/// that change nothing, and whether the words of its examples are accepted as they say. Several lines.
std::string describe(const std::shared_ptr<const Machine>& machine);

}  // namespace continua
