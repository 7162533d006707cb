// The engine's memory between ticks, and its account of each tick: values.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "continua/automaton/exploration.h"
#include "continua/behaviour/performance.h"
#include "continua/learning/learning.h"
#include "continua/moves/known_words.h"
#include "continua/moves/offer.h"
#include "continua/perception/pointed.h"

namespace continua {

struct EngineState {
  EngineState(Beliefs first_beliefs, Chooser first_chooser, Fusion first_fusion)
      : beliefs(std::move(first_beliefs)), chooser(std::move(first_chooser)), fusion(std::move(first_fusion)) {}

  Configuration configuration;  ///< under `explore` that of the leading branch
  Exploration exploration;      ///< all branches; empty under the other policies
  Beliefs beliefs;
  Chooser chooser;
  Fusion fusion;                  ///< the percepts that wait for their counterparts
  std::deque<Ensemble> complete;  ///< the ensembles to be attended to, in order
  std::string last_utterance;
  std::optional<Pointed> pointed;
  Learned learned;   ///< all lessons of the human
  Lessons lessons;   ///< the lessons of this run
  KnownWords words;  ///< by which speech is read
  int inputs = 0;    ///< so far; the running number of the latest is its serial
  Performance performance;
  int acts = 0;  ///< asked for so far; the running number of the latest

  /// Whether an input up to this serial has not been attended to yet.
  bool waits(int serial) const;
};

/// The event as an input symbol, as it arrived.
struct Perceived {
  int serial = 0;
  std::string symbol;
  int act = 0;  ///< number of the act whose end it is; 0: it is the human's
};

/// A pointing and the words that it goes with.
struct Bound {
  std::vector<std::string> words;
  Deixis deixis;
};

/// An input is attended to, with the pointings that go with it. The events after it are its consequences.
struct Attended {
  int serial = 0;
  SimTime arrived, at;
  std::vector<Bound> bound;
};

/// The meaning given to an input; one for each move of an utterance. Its applications follow, then the automaton's
/// steps.
struct Understood {
  Move move;
  std::vector<int> because;  ///< serials of the inputs that it draws on
  /// Of an n-best list: which of its alternatives this is, and whether it is the one that was gone on with.
  std::optional<std::size_t> alternative;
  double confidence = 1;
  bool taken = true;
};

/// A gesture that no command could be made of.
struct Unplanned {
  std::string reason;
};

/// Under `explore`: the other configurations that the automaton may be in.
struct Explored {
  std::vector<Branch> branches;
  std::vector<int> dropped;
  int merged = 0, pruned = 0;
};

/// Another avatar's observed moves after an input.
struct ObservedMoves {
  std::vector<std::string> said;
  std::vector<Term> gestures, acts;
};

/// The dialogue goes on from where another avatar's moves show it to be.
struct Corrected {
  StateIndex from = 0, to = 0;
  std::size_t implied = 0;  ///< by which of Machine::implied; 0: nothing was observed, so nothing had happened
  int stack = 0;
  std::size_t depth = 0;
};

using EngineEvent = std::variant<Perceived, Attended, Understood, BeliefChange, StepEvent, Explored, Corrected,
                                 GestureCommand, Unplanned, ActStep, ActEnd>;

struct Tick {
  EngineState after;
  std::vector<EngineEvent> events;  ///< in the order in which they happened

  /// Goes on with the next tick.
  void then(Tick next);
};

}  // namespace continua
