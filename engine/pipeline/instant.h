// Inputs of one instant. Their recognisers report them in any order, and the order must not matter (SEMANTICS.md §3,
// Ensembles).
#pragma once

#include "continua/pipeline/engine.h"

namespace continua {

/// Whether `a` is received before `b`, if both become known at one instant. The order depends on their content alone:
/// pointing gestures, samples, gestures that point where the hand does, gestures that are understood before their
/// words, then the rest by the time at which it happened, speech first.
bool comes_before(const Engine& engine, const EngineState& state, const InputEvent& a, const InputEvent& b);

}  // namespace continua
