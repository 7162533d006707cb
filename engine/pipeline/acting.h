// Acting as a stage: the acts that were asked for become commands to the body, and their ends become inputs.
#pragma once

#include <optional>
#include <string>

#include "continua/pipeline/engine.h"

namespace continua {

/// The symbol by which machines know how an act ended: `act done`, `act blocked`, …
std::string symbol_of(const ActEnd& end);

/// The end of an act as an input: `act`, `reason`, `why` and `concerned` (automaton/FORMAT.md). `serial` names it.
Input to_input(const ActEnd& end, int serial, SimTime now);

/// The way to the next end of an act that the machine knows as an input, or to where the body has to report first.
struct Performed {
  Tick tick;
  std::optional<ActEnd> end;  ///< the last of the events, if that is an input
};
Performed perform(const Engine& engine, EngineState state, const WorldSnapshot& world);

}  // namespace continua
