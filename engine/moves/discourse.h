// The context in which a move is understood: that of language/reference.h, taken from the machine's own values, and the
// inputs that these came from.
#pragma once

#include <vector>

#include "continua/automaton/stepper.h"
#include "continua/moves/move.h"

namespace continua {

struct Discourse {
  Context context;
  std::vector<int> focus, among, topic;  ///< serials of the inputs that these came from
  std::vector<std::vector<int>> shown;   ///< of each of the context's showings
};

/// The machine's `context`, evaluated in the configuration. Pointing is left out.
Discourse discourse_of(const Stepper& stepper, const Configuration& configuration, const Input& input,
                       const Facts& facts);

/// The inputs that a move draws on: its own, and those behind the parts that it took from the context.
std::vector<int> sources(const Move& move, int serial, const Discourse& discourse);
/// The same of one of its applications.
std::vector<int> sources(const Applying& applying, int serial, const Discourse& discourse);

}  // namespace continua
