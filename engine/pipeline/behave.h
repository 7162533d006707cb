// Behaviour as a stage: what the automaton emitted becomes words, gestures and acts of the avatar.
#pragma once

#include "continua/pipeline/step.h"

namespace continua {

/// All that the step brought about, in order. What the avatar says, the avatar hears itself. Acts are asked for; the
/// next stage (pipeline/acting.h) performs them.
Tick behave(const Engine& engine, Stepped stepped);

}  // namespace continua
