// What the automaton said is to be learned, forgotten or done, with what was learned until then.
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/step_event.h"
#include "continua/learning/learning.h"

namespace continua {

/// Whether a name computes something or the machine has another use for it: then no program can be called so.
bool is_taken(const std::string& name, const Machine& machine);

/// What comes of events, in order: of each itself, or
/// - of Taught, once it is learned, the same with what was composed; Trouble if it cannot be learned;
/// - of Forgotten one for each thing that was known, with its value;
/// - of the act of a learned program one Acted for each act that it comes to; Trouble if that are too many.
std::vector<StepEvent> with_lessons(std::vector<StepEvent> events, const Machine& machine, Learned& learned);

}  // namespace continua
