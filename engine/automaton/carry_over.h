// Lets a run go on with another machine: translates the configuration into that machine's states, slots and registers.
#pragma once

#include "continua/automaton/choice.h"
#include "continua/automaton/exploration.h"
#include "continua/automaton/machine.h"
#include "continua/core/result.h"

namespace continua {

/// Translates a configuration of the machine `was` into one of `now`, by names: the state, the slots of every stack
/// symbol, the registers. Further slots and registers of `now` are empty or have their declared value. Symbols keep
/// their ids. A state that only `now` names in a pop_until counts as not entered yet.
/// Errors, with the nearest name: `now` lacks the state, a slot that is not empty, or a register that has changed; or
/// it declares the slot or register for values of another type.
Result<Configuration> carried_over(const Configuration& configuration, const Machine& was, const Machine& now);

/// Translates the configuration of every branch.
Result<Exploration> carried_over(const Exploration& exploration, const Machine& was, const Machine& now);

/// Makes the three agree after a change of the chooser's policy. Under `explore` the configuration becomes the first
/// branch. Under any other policy the branches go, and the counts of steps and symbols continue from theirs.
void follow_policy(Chooser& chooser, Configuration& configuration, Exploration& exploration);

}  // namespace continua
