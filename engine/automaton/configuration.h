// What the automaton is in: state, stack, what it remembers of the states it came through, and its registers. An
// immutable value that shares structure (semantics §1).
#pragma once

#include <memory>
#include <vector>

#include "automaton/stack.h"

namespace continua {

/// Index of a state in Machine::states.
using StateIndex = std::size_t;

/// What pop_until can ask about the entries of states so far. Of each landmark, a state that some pop_until names, the
/// two latest entries are kept, each with the stack as it was then: an earlier one can never be asked for again.
class History {
 public:
  /// `landmark`: index of the state among the machine's landmarks, of which there are `count`.
  History entered(std::size_t landmark, std::size_t count, Stack stack) const;
  /// The stack at the latest entry but `skip` of the landmark, or nullptr if there was none. `skip` is 1 while the
  /// machine is in that state, since its latest entry is the present one; else 0.
  const Stack* entry(std::size_t landmark, std::size_t skip) const;

  /// No pop_until can tell them apart: the topmost symbols at the entries are the same.
  bool operator==(const History& other) const;

 private:
  struct Entries {
    Stack latest, earlier;  ///< empty: none
  };
  std::shared_ptr<const std::vector<Entries>> entries_;
};

struct Configuration {
  StateIndex state = 0;
  Stack stack;
  History history;
  std::shared_ptr<const std::vector<Cell>> memory;  ///< one for each register, in the machine's order; never null
  int next_symbol = 0;                              ///< id for the next symbol to be made

  /// Everything that decides how things go on is the same; ids and what values came from do not count.
  bool same_as(const Configuration& other) const;
};

}  // namespace continua
