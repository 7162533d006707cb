// Conditions of transitions: whether they hold, and why not.
#pragma once

#include <string>

#include "continua/automaton/machine.h"
#include "continua/term/evaluate.h"

namespace continua {

/// Whether the condition is true.
bool holds(const Term& condition, Evaluation& evaluation);

/// The first conjunct that fails, with the values it compared: "not size(options) >= 2: size(options) is 1". A failing
/// definition is opened: "nothing_held: not held = null: held is cup". REQUIRES that the condition does not hold.
std::string why_not(const Term& condition, const Machine& machine, Evaluation& evaluation);

}  // namespace continua
