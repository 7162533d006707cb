// Can two conditions hold at once? Answered from their text alone: no world, no configuration.
#pragma once

#include <optional>
#include <string>

#include "automaton/machine.h"

namespace continua {

/// What would have to hold for both conditions to hold, as a conjunction: "size(options) > 1 and region != null";
/// "" where neither asks for anything. Nothing if they exclude each other, by comparing one term with values that
/// do not go together, or by asking for a fact and its contrary. An answer is no proof: terms that are written
/// differently may depend on each other. Definitions are looked into; nullopt as a condition holds always.
std::optional<std::string> overlap(const std::optional<Term>& a, const std::optional<Term>& b, const Machine& machine);

}  // namespace continua
