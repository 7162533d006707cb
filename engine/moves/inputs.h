// Makes inputs of the automaton from events and moves.
#pragma once

#include "continua/automaton/input.h"
#include "continua/moves/move.h"
#include "continua/perception/input_event.h"

namespace continua {

/// The event as an input, before it is understood. `serial` names it.
Input to_input(const InputEvent& event, int serial);

/// Adds the terms of a move to the input.
void carry(const Move& move, Input& input);

Term point_term(const Vec3& p_W);

}  // namespace continua
