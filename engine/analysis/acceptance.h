// Acceptance of words, the classical question. The answer is decided in time polynomial in the length of the word, also
// with ε-cycles that grow the stack and with any number of branches.
//
// The machine is read as a pushdown system. A control is a state with registers, history and position in the word; the
// stack alphabet is the set of stack symbols that occur. The reachable configurations may be infinitely many, but their
// stacks are a regular set. The finite automaton of this set grows by saturation until nothing is left to add (post*:
// Bouajjani, Esparza & Maler 1997, "Reachability analysis of pushdown automata"; Schwoon 2002, "Model-checking pushdown
// systems", §3.1; with the position in the word as a part of the control it is Lang's tabulation of 1974). The parts of
// the stepper (automaton/firing.h) compute the change of the topmost symbol, so the verdict holds for the machine as it
// runs.
//
// ε-transitions are optional, as in the textbook. An input that no transition takes rejects the word.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"

namespace continua {

enum class AcceptBy {
  final_state,  ///< an accepting state once the word is read
  empty_stack,  ///< nothing but the bottom symbol once the word is read, in any state but a passing one
};

class Acceptance {
 public:
  explicit Acceptance(std::shared_ptr<const Machine> machine, AcceptBy by = AcceptBy::final_state);
  ~Acceptance();

  /// `word`: input symbols. Errors: the machine makes endlessly many stack symbols or registers (a counter in a slot),
  /// or has beliefs; then the question is not the classical one.
  Result<bool> accepts(const std::vector<std::string>& word);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace continua
