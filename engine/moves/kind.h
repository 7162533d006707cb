// The symbol under which a machine knows an event, and the kind of move that the event is.
#pragma once

#include <string>

#include "continua/automaton/machine.h"
#include "continua/learning/learning.h"
#include "continua/perception/gesture.h"
#include "continua/perception/input_event.h"

namespace continua {

/// A gesture that was taught is a move that says an action. `gestures`: nullptr, gestures are known by their names.
std::string symbol_of(const InputEvent& event, const GestureCatalogue* gestures, const Learned& learned);

/// By the machine's own table of moves, else by lessons and catalogue; empty if the event is no move by itself.
std::string kind_of(const InputEvent& event, const Machine& machine, const GestureCatalogue* gestures,
                    const Learned& learned);

}  // namespace continua
