// The stage of acting: requested acts become commands to the body, and their ends become inputs.
#pragma once

#include <optional>
#include <string>

#include "continua/pipeline/engine.h"

namespace continua {

/// The input symbol for the end of an act: `act done`, `act blocked`, …
std::string symbol_of(const ActEnd& end);

/// The end of an act as an input: `act`, `reason`, `why` and `concerned` (automaton/FORMAT.md). `serial` names it.
Input to_input(const ActEnd& end, int serial, SimTime now);

/// The events up to the next end of an act that is an input of the machine, or until the body has to report first.
struct Performed {
  Tick tick;
  std::optional<ActEnd> end;  ///< the last event, if it is an input
};
Performed perform(const Engine& engine, EngineState state, const WorldSnapshot& world);

}  // namespace continua
