// Inputs for the automaton, made of percepts and moves.
#pragma once

#include "continua/automaton/input.h"
#include "continua/moves/move.h"
#include "continua/perception/input_event.h"

namespace continua {

/// The event as an input, before anything is understood. `serial` names it.
Input to_input(const InputEvent& event, int serial);

/// Adds the content of a move to the input.
void carry(const Move& move, Input& input);

Term point_term(const Vec3& p_W);

}  // namespace continua
