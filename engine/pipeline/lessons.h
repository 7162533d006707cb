// Carries out the automaton's deeds of learning and forgetting, and replaces taught programs by their acts.
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/step_event.h"
#include "continua/learning/learning.h"

namespace continua {

/// Whether a name computes something or the machine has another use for it: then no program can be called so.
bool is_taken(const std::string& name, const Machine& machine);

/// The events as lessons change them, in order.
/// - `Taught`, once it is learned, has the program that was composed; it becomes `Trouble` if it cannot be learned.
/// - `Forgotten` becomes one `Forgotten` for each lesson that was known, with its value.
/// - An `Acted` of a taught program becomes one `Acted` for each of its acts, or a `Trouble` if there are too many.
/// - Other events stay.
std::vector<StepEvent> with_lessons(std::vector<StepEvent> events, const Machine& machine, Learned& learned);

}  // namespace continua
