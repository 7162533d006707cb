// From what the automaton has the avatar do to what its body is told, and back: what came of an act is an input.
#pragma once

#include <string>

#include "continua/automaton/input.h"
#include "continua/behaviour/performance.h"

namespace continua {

/// A gesture that no command could be made of.
struct Unplanned {
  std::string reason;
};

/// The symbol by which machines know how an act ended: `act done`, `act blocked`, …
std::string symbol_of(const ActEnd& end);

/// The end of an act as an input: `act`, `reason`, `why` and `concerned` (automaton/FORMAT.md). `serial` names it.
Input to_input(const ActEnd& end, int serial, SimTime now);

}  // namespace continua
