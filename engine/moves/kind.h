// The symbol under which a machine knows an event, and the kind of move that the event is.
#pragma once

#include <string>

#include "continua/automaton/machine.h"
#include "continua/learning/learning.h"
#include "continua/perception/gesture.h"
#include "continua/perception/input_event.h"

namespace continua {

/// A taught gesture is a move that shows an action. `gestures`: nullptr: gestures are known by their names.
std::string symbol_of(const InputEvent& event, const GestureCatalogue* gestures, const Learned& learned);

/// By the machine's table of moves, else by lessons and catalogue; empty if the event alone is not a move.
std::string kind_of(const InputEvent& event, const Machine& machine, const GestureCatalogue* gestures,
                    const Learned& learned);

}  // namespace continua
