// Carries a configuration over to another machine, so that a run can go on with it.
#pragma once

#include "continua/automaton/choice.h"
#include "continua/automaton/exploration.h"
#include "continua/automaton/machine.h"
#include "continua/core/result.h"

namespace continua {

/// The configuration of a run of the machine `was` as one of `now`, by names: its state, the slots of every symbol of
/// the stack, the registers. Slots and registers that `now` alone has are empty, or as it declares them. Symbols keep
/// their ids. A state that `now` alone names in a pop_until counts as not entered yet.
/// Errors, with the nearest name: `now` lacks the state, a slot that is not empty, or a register that has changed; or
/// `now` has it for values of another type.
Result<Configuration> carried_over(const Configuration& configuration, const Machine& was, const Machine& now);

/// The same of every branch.
Result<Exploration> carried_over(const Exploration& exploration, const Machine& was, const Machine& now);

/// Makes the three agree after a change of the chooser's policy: under `explore` there are branches, at least the
/// configuration; under any other policy there are none. Steps and symbols are counted on from those of the branches.
void follow_policy(Chooser& chooser, Configuration& configuration, Exploration& exploration);

}  // namespace continua
