// The context in which a move is understood (language/reference.h), from the machine's `context` terms, with its
// sources.
#pragma once

#include <vector>

#include "continua/automaton/stepper.h"
#include "continua/moves/earlier_pointing.h"
#include "continua/moves/move.h"

namespace continua {

struct Discourse {
  Context context;
  std::vector<int> focus, among, topic, handled;  ///< the sources of these (automaton/stack.h)
  std::vector<std::vector<int>> shown;            ///< serials of the inputs of each of the context's showings
  std::vector<int> pieces;                        ///< serials of inputs with earlier words of the utterance
  EarlierPointings earlier;                       ///< pointings without words
  std::vector<int> pointed;                       ///< the sources of these
};

/// The machine's `context`, evaluated in the configuration. Pointing is left out.
Discourse discourse_of(const Stepper& stepper, const Configuration& configuration, const Input& input,
                       const Facts& facts);

/// The sources of a move: its own input, and the sources of the parts of the context that it used.
std::vector<int> sources(const Move& move, int serial, const Discourse& discourse);
/// The sources of one of its applications.
std::vector<int> sources(const Applying& applying, int serial, const Discourse& discourse);

}  // namespace continua
