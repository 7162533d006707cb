// Conditions of transitions, and why one does not hold.
#pragma once

#include <string>

#include "continua/automaton/machine.h"
#include "continua/term/evaluate.h"

namespace continua {

/// Of a condition that does not hold, the first conjunct that fails, with the values it compared:
/// "not size(options) >= 2: size(options) is 1". Definitions are looked into: "nothing_held: not held = null: held is
/// cup".
std::string why_not(const Term& condition, const Machine& machine, Evaluation& evaluation);

}  // namespace continua
