// An ensemble as moves that the automaton is offered: words or a gesture, with the pointings that go with them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continua/automaton/stepper.h"
#include "continua/moves/move.h"
#include "continua/moves/readings.h"

namespace continua {

/// For each word and gesture that the human taught in this run the serials of the inputs that it was learned from.
using Lessons = std::map<std::string, std::vector<int>, std::less<>>;

/// The dialogue as it stands when something is understood; all must outlive its use.
struct Dialogue {
  const Stepper& stepper;
  const Configuration& configuration;
  Facts facts;  ///< REQUIRES world and lessons
  const Lessons& lessons;
  FusionWindow window;
  const GestureCatalogue* gestures = nullptr;  ///< null: gestures are known by their names
  std::optional<Understanding> understanding;  ///< none for a machine without a lexicon
};

/// One move as the automaton may take it.
struct Offer {
  std::size_t alternative = 0;  ///< of the recogniser's
  std::size_t fragment = 0;     ///< of speech: which of the utterance's moves
  Move move;
  Input input;                   ///< `because` holds all inputs that it draws on, its own among them
  std::vector<Applied> applied;  ///< by understanding
};

/// The first move of each alternative; the automaton takes one of them. REQUIRES readings of speech where there is
/// understanding.
std::vector<Offer> offers_of(const Ensemble& ensemble, const Dialogue& now);

/// The next move of the utterance whose last move was taken; nothing if there is no other.
std::optional<Offer> next_offer(const Offer& taken, const Ensemble& ensemble, const Dialogue& now);

}  // namespace continua
