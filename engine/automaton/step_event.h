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
  std::string reason;           ///< the first conjunct of its condition that fails, with its values; or the higher rank
  std::size_t alternative = 0;  ///< number of the input that it would have taken, among those offered
  std::optional<std::size_t> outranked_by = {};  ///< its condition holds, but so does that of this transition
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
  const Operation* operation = nullptr;  ///< of the transition, or of the last gate that refused
  std::vector<Candidate> candidates;
  std::vector<Refused> refused;
  std::vector<GateTest> gates;  ///< of the state it leads to, then of each `else`; only the last may pass
  double probability = 1;       ///< the chosen candidate's share of all weights
  std::optional<double> draw;   ///< under Choice::sample, with more than one candidate
  bool forced = false;
  int stack = 0;
  std::size_t depth = 0;
  double margin = 0;             ///< infinity if nothing was compared
  std::size_t alternative = 0;   ///< number of the input taken, among those offered
  std::size_t alternatives = 0;  ///< number of inputs offered; 0: ε
};

struct MadeSymbol {
  int id = 0;
  std::optional<int> below;
  Symbol symbol;
  std::vector<int> because = {};  ///< sources of the values that are new in it
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
  std::string text;                   ///< one of `variants`; the first unless another was chosen
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
  int number = 0;  ///< source_of_write(number) names the value as a source
  std::vector<int> because = {};
};
/// A lesson to learn or forget. The automaton only reports it and does not change.
struct Taught {
  Lesson of = Lesson::gesture;
  std::string name;
  Term value;  ///< the meaning of the gesture, the acts of the word as a list, or the noun's condition
  std::vector<int> because;
  bool fixed = false;  ///< of a word: its acts keep their objects; otherwise these become arguments
};
struct Forgotten {
  std::optional<Lesson> of;  ///< nullopt: all that was learned
  std::string name;
  Term value;  ///< the forgotten lesson, once it is known
  std::vector<int> because;
};
/// A waiting input of this number is to be attended to now, as if it were sure.
struct Reattended {
  int number = 0;
  double now_s = 0;
  std::vector<int> because;
};
struct RefusedInput {
  StateIndex state = 0;
  std::string input;   ///< the first input offered
  std::string reason;  ///< with several inputs, a reason for each
  std::vector<Refused> refused;
  std::size_t alternatives = 1;  ///< number of inputs offered
};
/// A part of the machine that cannot be carried out as written, such as an ε-cycle.
struct Trouble {
  std::string message;
  bool endless = false;  ///< ε-transitions went on and on, so the step did not come to its end
};

using StepEvent = std::variant<Fired, MadeSymbol, Rewrote, Applied, Said, Gestured, Acted, Remembered, Taught,
                               Forgotten, Reattended, RefusedInput, Trouble>;

}  // namespace continua
