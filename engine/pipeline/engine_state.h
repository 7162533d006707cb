// What the engine remembers between ticks, and what it tells of each: values.
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
  Fusion fusion;                  ///< what waits for its counterpart
  std::deque<Ensemble> complete;  ///< what is to be attended to, in order
  std::string last_utterance;
  std::optional<Pointed> pointed;
  Learned learned;   ///< what the human taught
  Lessons lessons;   ///< what was learned in this run
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

/// An input is attended to, with the pointings that go with it: what follows comes of it.
struct Attended {
  int serial = 0;
  SimTime arrived, at;
  std::vector<Bound> bound;
};

/// What an input was taken to mean; for each move of an utterance one. What it applied follows, then what the
/// automaton did with it.
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

/// Under `explore`: what the automaton may be in beside what led to the events before it.
struct Explored {
  std::vector<Branch> branches;
  std::vector<int> dropped;
  int merged = 0, pruned = 0;
};

/// What another avatar was observed to do after an input.
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

  /// Goes on with what happened next.
  void then(Tick next);
};

}  // namespace continua
