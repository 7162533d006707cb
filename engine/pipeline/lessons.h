// Carries out lessons: applies the automaton's `Taught`, `Forgotten` and `Acted` to the knowledge learned so far.
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/step_event.h"
#include "continua/learning/learning.h"

namespace continua {

/// Whether the name is a function, a fact, or in use in the machine: then no program can have it.
bool is_taken(const std::string& name, const Machine& machine);

/// The events as lessons change them, in order.
/// - `Taught` of a word gets the composed program; it becomes `Trouble` if the lesson cannot be learned.
/// - `Forgotten` becomes one `Forgotten` for each lesson that was known, with its value.
/// - An `Acted` of a taught program becomes one `Acted` for each of its acts, or a `Trouble` if there are too many.
/// - Other events stay.
std::vector<StepEvent> with_lessons(std::vector<StepEvent> events, const Machine& machine, Learned& learned);

}  // namespace continua
