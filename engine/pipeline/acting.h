// The stage of acting: requested acts become commands to the body, and their ends become inputs.
#pragma once

#include <optional>
#include <string>

#include "continua/pipeline/engine.h"

namespace continua {

/// The input symbol for the beginning or the end of an act: `act started`, `act done`, `act blocked`, …
std::string symbol_of(const ActEnd& news);

/// The news of an act as an input: `act`, `reason`, `why` and `concerned` (automaton/FORMAT.md). `serial` names it.
Input to_input(const ActEnd& news, int serial, SimTime now);

/// The events up to the next beginning or end of an act that is an input of the machine, or until the body has to
/// report first.
struct Performed {
  Tick tick;
  std::optional<ActEnd> news;  ///< the input; of a beginning, the status is `started`
};
Performed perform(const Engine& engine, EngineState state, const WorldSnapshot& world);

}  // namespace continua
