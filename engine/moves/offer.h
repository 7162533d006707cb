// Makes offers of an ensemble: the moves that it says or shows, as inputs that the automaton may take.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continua/automaton/stepper.h"
#include "continua/moves/move.h"
#include "continua/moves/readings.h"

namespace continua {

/// Words and gestures that the human taught in this run, with the serials of the inputs of the lesson.
using Lessons = std::map<std::string, std::vector<int>, std::less<>>;

/// A taught gesture that was shown: its own name, under which a lesson corrects its meaning.
struct Sign {
  std::string gesture;
  SimTime t;
};

/// The present state of the dialogue, for understanding. All parts must outlive its use.
struct Dialogue {
  const Stepper& stepper;
  const Configuration& configuration;
  Facts facts;  ///< REQUIRES world and lessons
  const Lessons& lessons;
  FusionWindow window;
  const GestureCatalogue* gestures = nullptr;  ///< nullptr: gestures are known by their names
  std::optional<Sign> sign;                    ///< the latest
  std::optional<Understanding> understanding;  ///< none for a machine without a lexicon
};

/// A move as an input that the automaton may take.
struct Offer {
  std::size_t alternative = 0;  ///< number of the recogniser's alternative
  std::size_t fragment = 0;     ///< of speech: number of the move in the utterance
  Move move;
  Input input;                   ///< its `because` has all inputs that it draws on, with its own
  std::vector<Applied> applied;  ///< applications of its interpretation
  std::optional<Sign> sign;      ///< of a gesture that was taught
};

/// The first move of each alternative; the automaton takes one of them. Of an utterance that is resumed at a later
/// move, that move alone. REQUIRES readings of speech if there is an understanding.
std::vector<Offer> offers_of(const Ensemble& ensemble, const Dialogue& now);

/// The move of the same utterance after `taken`; nothing if there is none.
std::optional<Offer> next_offer(const Offer& taken, const Ensemble& ensemble, const Dialogue& now);

}  // namespace continua
