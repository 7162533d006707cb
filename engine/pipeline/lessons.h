// Carries out lessons: applies the automaton's `Taught`, `Forgotten` and `Acted` to the knowledge learned so far.
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/step_event.h"
#include "continua/learning/learning.h"
#include "continua/learning/shapes.h"

namespace continua {

/// Whether the name is a function, a fact, or in use in the machine: then no program can have it.
bool is_taken(const std::string& name, const Machine& machine);

/// The shapes that lessons may be about.
struct Seen {
  const ShownShapes& shapes;
  ShapeLimits limits;
};

/// The events as lessons change them, in order.
/// - `Taught` of a gesture makes an exemplar of the shape that it was shown with, if any.
/// - `Taught` of a word gets the composed program; it becomes `Trouble` if the lesson cannot be learned.
/// - `Forgotten` becomes one `Forgotten` for each lesson that was known, with its value. A gesture's exemplars go with
/// it,
///   and so do lessons of the same meaning by whose exemplars it would still be recognised.
/// - An `Acted` of a taught program becomes one `Acted` for each of its acts, or a `Trouble` if there are too many.
/// - Other events stay.
std::vector<StepEvent> with_lessons(std::vector<StepEvent> events, const Machine& machine, const Seen& seen,
                                    Learned& learned);

}  // namespace continua
