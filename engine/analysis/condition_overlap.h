// Overlap of two conditions: can both hold at once? The answer comes from their terms alone, without a world or a
// configuration.
#pragma once

#include <optional>
#include <string>

#include "continua/automaton/machine.h"

namespace continua {

/// A conjunction under which both conditions hold, "size(options) > 1 and region != null"; "" if neither requires
/// anything. Nothing if they exclude each other: they compare one term with values that cannot both be its value, or
/// require a fact and its contrary. A conjunction is not a proof, because terms with different texts may depend on each
/// other. Definitions are expanded. The condition nullopt always holds.
std::optional<std::string> overlap(const std::optional<Term>& a, const std::optional<Term>& b, const Machine& machine);

}  // namespace continua
