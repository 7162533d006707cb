// The state of the engine between ticks, and the events of a tick: values.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "continua/automaton/exploration.h"
#include "continua/automaton/looked.h"
#include "continua/behaviour/performance.h"
#include "continua/learning/learning.h"
#include "continua/learning/shapes.h"
#include "continua/moves/known_words.h"
#include "continua/moves/offer.h"
#include "continua/perception/gaze.h"
#include "continua/perception/pointed.h"

namespace continua {

/// Acts change nothing, though they begin: a gesture may still contradict the words that asked for them.
struct Hold {
  SimTime until;
  std::optional<int> inputs = {};  ///< then, until no input up to this serial waits
};

/// Its queues are vectors: they are short, and the state is moved from stage to stage, where each deque would allocate.
struct EngineState {
  EngineState(Beliefs first_beliefs, Chooser first_chooser, Fusion first_fusion)
      : beliefs(std::move(first_beliefs)), chooser(std::move(first_chooser)), fusion(std::move(first_fusion)) {}

  Configuration configuration;  ///< under `explore`: of the leading branch
  Exploration exploration;      ///< all branches; empty under the other policies
  Beliefs beliefs;
  Chooser chooser;
  Fusion fusion;                   ///< percepts that wait for their counterparts
  std::vector<Ensemble> complete;  ///< ensembles to attend to, in order
  std::string last_utterance;
  std::optional<Pointed> pointed;
  GazeTrack gaze;
  Looked looked;  ///< the objects looked at lately, at the latest input
  /// Readings that wait until the human says whether they were meant, by number; 0: the input under way.
  std::map<int, Ensemble> doubted;
  int doubts = 0;            ///< the number of the latest of them
  Learned learned;           ///< gestures and actions that the human taught
  ShownShapes shapes;        ///< of the gestures shown last
  std::optional<Sign> sign;  ///< the taught gesture that was shown last
  Lessons lessons;           ///< names learned in this run, with the inputs of their lessons
  KnownWords words;          ///< for reading speech
  int inputs = 0;            ///< number of inputs so far; the serial of the latest
  Performance performance;
  std::optional<Hold> hold = {};
  int acts = 0;  ///< number of acts requested so far; the number of the latest

  /// Whether an input up to this serial has not been attended to yet.
  bool waits(int serial) const;
};

/// An event arrived; its input symbol.
struct Perceived {
  int serial = 0;
  std::string symbol;
  int act = 0;  ///< number of the act that ended; 0: an event of the human's
};

/// A pointing and its words.
struct Bound {
  std::vector<std::string> words;
  Deixis deixis;
};

/// The engine attends to an input with its pointings. The events that follow are consequences.
struct Attended {
  int serial = 0;
  SimTime happened, at;  ///< the beginning of the input, and the time at which it was complete
  std::vector<Bound> bound;
  std::vector<int> pieces;   ///< serials of earlier inputs whose words it goes on with
  std::string text;          ///< the words of all pieces; empty if there is only one
  std::vector<int> assured;  ///< serials of the inputs that made it sure, if it was asked about
};

/// The understanding of an input, or of one move of an utterance. Its applications follow, then the automaton's
/// response.
struct Understood {
  Move move;
  std::vector<int> because;  ///< the sources that it draws on (automaton/stack.h)
  /// For an n-best list: the number of the alternative, and whether the automaton took it.
  std::optional<std::size_t> alternative;
  double confidence = 1;
  bool taken = true;
};

/// A gesture of the avatar that could not be planned as a command.
struct Unplanned {
  std::string reason;
};

/// Under `explore`: an event of a branch that does not lead. Its acts and words are not carried out.
struct Branched {
  int branch = 0, parent = 0;
  StepEvent event;
};

/// Under `explore`: all branches. The other events before it belong to the leading one.
struct Explored {
  std::vector<Branch> branches;
  std::vector<int> dropped;
  int merged = 0, pruned = 0;
};

/// The observed moves of another avatar after an input.
struct ObservedMoves {
  std::vector<std::string> said;
  std::vector<Term> gestures, acts;
};

/// The dialogue goes on from the configuration that another avatar's moves imply.
struct Corrected {
  StateIndex from = 0, to = 0;
  std::size_t implied = 0;  ///< number of the row of Machine::implied; 0: no move was observed
  int stack = 0;
  std::size_t depth = 0;
};

using EngineEvent = std::variant<Perceived, Attended, Understood, BeliefChange, StepEvent, Branched, Explored,
                                 Corrected, GestureCommand, Unplanned, ActStep, ActEnd>;

struct Tick {
  EngineState after;
  std::vector<EngineEvent> events;  ///< in the order in which they happened

  /// Appends the events of the next tick and takes its state.
  void then(Tick next);
};

}  // namespace continua
