// What the automaton is in: state, stack, the states it came through, and its registers. An immutable value that
// shares structure (semantics §1).
#pragma once

#include <memory>
#include <vector>

#include "automaton/stack.h"

namespace continua {

/// Index of a state in Machine::states.
using StateIndex = std::size_t;

/// The entries of states so far, newest first, each with the stack as it was then.
class History {
 public:
  History entered(StateIndex state, Stack stack) const;
  /// The stack at the latest entry of `state` but for the newest entry of all, or nullptr if there is none.
  const Stack* previous(StateIndex state) const;

 private:
  struct Node;
  std::shared_ptr<const Node> newest_;
};

struct Configuration {
  StateIndex state = 0;
  Stack stack;
  History history;
  std::vector<Cell> memory;  ///< one for each register, in the machine's order
  int next_symbol = 0;       ///< id for the next symbol to be made

  /// Same state, stack and registers: what decides how things go on, but for pop_until.
  bool same_as(const Configuration& other) const;
};

}  // namespace continua
