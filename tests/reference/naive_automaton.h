// A second automaton, written from its definition alone and slowly: whole stacks and whole histories are copied, sets
// are searched from end to end. It is the reference for the engine on small machines.
//
// A stack symbol has a character for each slot: '-' is null. The slots are `symbol` and `held`, which persists; a
// machine with one slot leaves the second null. A pattern over the slots has a character for each, too:
//
//   condition   '.' anything   '-' 'A' 'B' this value
//   content     '.' unchanged  '-' 'A' 'B' this value   '0' '1' the value of the slot of this number
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace naive {

using Symbol = std::array<char, 2>;
using Pattern = std::string;
using Stack = std::vector<Symbol>;  ///< the bottom first

struct Operation {
  enum class Kind { none, push, push_each, pop, rewrite, rewrite_each, flush, pop_until };
  Kind kind = Kind::none;
  std::vector<Pattern> contents;  ///< one for push, rewrite and flush, any number for …_each
  int count = 1;                  ///< pop
  int state = 0;                  ///< pop_until
};

struct Gate {
  Pattern when;
  int otherwise = 0;
  Operation operation;
};

struct State {
  bool accepting = false;
  std::optional<Gate> gate;
};

struct Transition {
  std::set<int> from;
  std::string on;  ///< the inputs it takes, a character each; empty: ε
  Pattern when;
  int to = 0;
  double weight = 1;
  Operation operation;
  int rank = 0;  ///< it is applicable only where none of a higher rank is
};

struct Machine {
  int slots = 1;
  bool unique = false;         ///< of several applicable transitions none is taken; else the heaviest
  bool epsilon_always = true;  ///< else only after a rewrite
  std::vector<State> states;   ///< a run begins in the first
  std::vector<Transition> transitions;
};

struct Configuration {
  int state = 0;
  Stack stack;
  std::vector<std::pair<int, Symbol>> history;  ///< every state entered, with the topmost symbol of that moment
};

enum class Trouble {
  none,
  cycle,    ///< ε-transitions lead back to a configuration they came from
  endless,  ///< ε-transitions go on and on
  gates,    ///< gates refuse in a circle
};

struct Step {
  Configuration after;
  bool refused = false;
  Trouble trouble = Trouble::none;
  std::size_t taken = 0;  ///< which of the inputs offered
};

/// One of several inputs of which one is to be taken.
struct Offer {
  char input;
  double confidence;
};

Step begin(const Machine& machine);
Step step(const Machine& machine, const Configuration& before, const std::vector<Offer>& offers);
inline Step step(const Machine& machine, const Configuration& before, char input) {
  return step(machine, before, {{input, 1}});
}

/// The configuration of a run that has not yet tried any ε-transition.
Configuration start();
/// The transitions that apply, in file order. `input` is nullopt for ε.
std::vector<Transition> applicable(const Machine& machine, const Configuration& configuration,
                                   std::optional<char> input);
/// Nothing where gates refuse in a circle.
std::optional<Configuration> fire(const Machine& machine, const Configuration& before, const Transition& transition);
/// Where a transition leads from a topmost symbol, and the operation done on the way, which may be a gate's.
struct Way {
  int to = 0;
  Operation operation;
};
std::optional<Way> way_through_gates(const Machine& machine, const Symbol& top, const Transition& transition);

bool fits(const Symbol& symbol, const Pattern& condition);
/// '.' keeps the value of `before`; '0' '1' copy from `top`, the topmost symbol before the operation.
Symbol filled(const Pattern& content, const Symbol& before, const Symbol& top);
Symbol flushed(const Pattern& content, const Symbol& top);
inline const Symbol bottom = {'-', '-'};

/// Whether both have the same future: state, stack, and as much of the history as a pop_until may look at.
bool same(const Machine& machine, const Configuration& a, const Configuration& b);

}  // namespace naive
