// Whether a trace's `expect` lines hold at their point of a replay (traces/FORMAT.md).
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/replay/trace/trace_file.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// The circumstances that an expectation is checked against.
struct Situation {
  const Machine& machine;
  const Configuration& configuration;
  WorldSnapshot world;
  std::vector<std::string> said;       ///< since the last input, in order
  std::string last_act;                ///< the program asked for last, or empty
  std::vector<std::string> referents;  ///< of the last noun phrase or pointing
};

struct Checked {
  bool met = true;
  Json found;  ///< for each expected field, the value found
};

Checked check(const Expectation& expectation, const Situation& situation);

}  // namespace continua
