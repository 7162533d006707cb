// The words, gestures and deeds of human and avatar in a run, as lines of a dialogue.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"

namespace continua {

struct DialogueLine {
  std::size_t n = 0;  ///< of its record
  SimTime t{};
  std::string who;  ///< "human", "avatar", "expectation"
  std::string how;  ///< "says", "shows", "does", "did not" an act, "did not take" an input, "is" not met
  std::string what;
};

/// In the log's order. Samples of pointing, steps of acts and acts that went well tell nothing to a reader: they are
/// left out, as are records that cannot be read.
std::vector<DialogueLine> dialogue_of(const RunIndex& run);

}  // namespace continua
