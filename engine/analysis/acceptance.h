// The classical question: does a machine accept a word? Decided, not searched for: λ-cycles, also growing ones, and any
// number of branches end in an answer, in time polynomial in the length of the word.
//
// A configuration of the machine is read as one of a pushdown system: its control is the state with registers, history
// and position in the word; its stack alphabet the stack symbols that occur. The reachable configurations, infinitely
// many as they may be, are a regular set of stacks, and the finite automaton of that set grows by saturation until
// nothing is left to add (post*: Bouajjani, Esparza & Maler 1997, "Reachability analysis of pushdown automata";
// Schwoon 2002, "Model-checking pushdown systems", §3.1; with the position in the word as a part of the control it is
// Lang's tabulation of 1974). What a transition does to the topmost symbol is asked of the stepper's own parts
// (automaton/firing.h), so that the verdict is about the machine as it runs.
//
// ε-transitions are optional, as in the textbook, and inputs that no transition takes reject the word.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "automaton/machine.h"
#include "core/result.h"

namespace continua {

enum class AcceptBy {
  final_state,  ///< an accepting state once the word is read
  empty_stack,  ///< nothing but the bottom symbol once the word is read, in any state but a passing one
};

class Acceptance {
 public:
  explicit Acceptance(std::shared_ptr<const Machine> machine, AcceptBy by = AcceptBy::final_state);
  ~Acceptance();

  /// `word`: input symbols. An error where the question is not a classical one: the machine makes stack symbols or
  /// registers without end (a counter in a slot), or has beliefs.
  Result<bool> accepts(const std::vector<std::string>& word);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace continua
