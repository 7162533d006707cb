// The stage of behaviour: the effects of the automaton become words, gestures and acts of the avatar.
#pragma once

#include "continua/pipeline/step.h"

namespace continua {

/// All effects of the step, in order. The avatar hears its own utterances. Acts are only requested; the next stage
/// (pipeline/acting.h) performs them.
Tick behave(const Engine& engine, Stepped stepped);

}  // namespace continua
