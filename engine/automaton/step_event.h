// The events of a step of the automaton, for the log: values, in the order in which they happened.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/term/evaluate.h"

namespace continua {

struct Refused {
  std::size_t transition = 0;
  std::string reason;           ///< the first part of its condition that does not hold, with the values it saw
  std::size_t alternative = 0;  ///< which of the inputs offered it would have taken
};

struct GateTest {
  StateIndex state = 0;
  std::string condition;
  bool passed = true;
};

struct Fired {
  std::size_t transition = 0;
  int step = 0;  ///< running number of the transitions of a run, from 1
  StateIndex from = 0, to = 0;
  std::optional<std::string> input;      ///< nullopt: ε
  const Operation* operation = nullptr;  ///< the machine's; that of the last gate that refused
  std::vector<Candidate> candidates;
  std::vector<Refused> refused;
  std::vector<GateTest> gates;  ///< of the state it leads to, then of each `else` on the way; only the last may pass
  double probability = 1;       ///< the chosen candidate's share of all weights
  std::optional<double> draw;   ///< under Choice::sample, with more than one candidate
  bool forced = false;
  int stack = 0;
  std::size_t depth = 0;
  double margin = 0;             ///< infinity when nothing was compared
  std::size_t alternative = 0;   ///< which of the inputs offered was taken
  std::size_t alternatives = 0;  ///< how many were; 0: ε
};

struct MadeSymbol {
  int id = 0;
  std::optional<int> below;
  Symbol symbol;
};
struct Rewrote {
  StateIndex state = 0;
  const Operation* operation = nullptr;
  int stack = 0;
  std::size_t depth = 0;
};
struct Applied {
  Application application;
  std::vector<int> because;
};
struct Said {
  std::string text;                   ///< one of `variants`, the first unless someone chose
  std::vector<std::string> variants;  ///< all ways to say it
  std::vector<int> because;
};
struct Gestured {
  Term term;
  std::vector<int> because;
};
struct Acted {
  Term term;
  std::vector<int> because;
};
struct Remembered {
  std::size_t index = 0;
  Term value;
};
/// The automaton only says that something is to be learned or forgotten: nothing in it changes.
struct Taught {
  Lesson of = Lesson::gesture;
  std::string name;
  Term value;  ///< the meaning; for a word the list of its acts
  std::vector<int> because;
};
struct Forgotten {
  std::optional<Lesson> of;  ///< nullopt: all that was learned
  std::string name;
  Term value;  ///< the forgotten meaning, once it is known
  std::vector<int> because;
};
struct RefusedInput {
  StateIndex state = 0;
  std::string input;   ///< the first of those offered
  std::string reason;  ///< where several were offered, one for each
  std::vector<Refused> refused;
  std::size_t alternatives = 1;  ///< how many inputs were offered
};
/// Something in the machine that cannot be carried out as written, such as an ε-cycle.
struct Trouble {
  std::string message;
};

using StepEvent = std::variant<Fired, MadeSymbol, Rewrote, Applied, Said, Gestured, Acted, Remembered, Taught,
                               Forgotten, RefusedInput, Trouble>;

}  // namespace continua
