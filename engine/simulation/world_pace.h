// The time that a scene's physics takes to work out, for scenes that nobody could wait for.
#pragma once

#include "continua/core/result.h"
#include "continua/simulation/scene.h"

namespace continua {

/// A world that takes longer than so many times its own time is refused. A usual one takes a fiftieth of its time.
inline constexpr double slowest_pace = 20;

/// Processor time of this thread alone, in seconds: other programs do not count.
double processor_s();

/// Steps a copy of the world for a moment. Error: it is slower than slowest_pace, and the things that make it so.
Outcome check_pace(const Scene& scene);

}  // namespace continua
