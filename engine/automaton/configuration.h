// What the automaton is in: state, stack, what it remembers of the states it came through, and its registers. An
// immutable value that shares structure (semantics §1).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "continua/automaton/stack.h"

namespace continua {

/// Index of a state in Machine::states.
using StateIndex = std::size_t;

/// What pop_until can ask about the entries of states so far: for each landmark, a state that some pop_until names, the
/// stack at its latest entry; for the state the machine is in, which was entered just now, that of the entry before.
/// Nothing earlier can ever be asked for.
class History {
 public:
  /// A state was entered. `landmark`: its number among the machine's landmarks, of which there are `count`; nullopt if
  /// it is none.
  History entered(std::optional<std::size_t> landmark, std::size_t count, const Stack& stack) const;
  /// The stack at the latest entry of the landmark; while the machine is in it (`present`) at the one before that.
  /// nullptr if there was none.
  const Stack* entry(std::size_t landmark, bool present) const;

  /// No pop_until can tell them apart: the topmost symbols at the entries are the same.
  bool operator==(const History& other) const;

 private:
  std::shared_ptr<const std::vector<Stack>> latest_;  ///< empty stack: never entered
  Stack before_;                                      ///< empty: no landmark, or entered for the first time
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
