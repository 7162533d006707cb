// A configuration of the automaton: state, stack, the history that pop_until asks about, and the registers. An
// immutable value that shares structure (SEMANTICS.md §1).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "continua/automaton/stack.h"

namespace continua {

/// Index of a state in Machine::states.
using StateIndex = std::size_t;

/// The entries of states that pop_until can ask about: for each landmark (a state that some pop_until names) the stack
/// at its latest entry; for the present state, which was entered just now, that of the entry before. Nothing earlier
/// can ever be asked for.
class History {
 public:
  /// A state was entered. `landmark`: its number among the machine's `count` landmarks; nullopt for any other state.
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

  /// Whether both go on alike: everything but ids and origins of values is the same.
  bool same_as(const Configuration& other) const;
};

}  // namespace continua
