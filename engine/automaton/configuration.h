// The configuration of the automaton: state, stack, history of entered states, registers. An immutable value that
// shares structure (SEMANTICS.md §1).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "continua/automaton/stack.h"

namespace continua {

/// Index of a state in Machine::states.
using StateIndex = std::size_t;

/// The entries of states, as far as pop_until can ask for them. A landmark is a state that some pop_until names. Kept
/// are the stack at the latest entry of each landmark and, if the present state is a landmark, the stack at its entry
/// before.
class History {
 public:
  /// The history after a state is entered with this stack. `landmark`: the state's number among the machine's `count`
  /// landmarks; nullopt if it is not a landmark.
  History entered(std::optional<std::size_t> landmark, std::size_t count, const Stack& stack) const;
  /// The stack at the latest entry of the landmark; with `present` (the machine is in that state), at the entry before.
  /// nullptr if there was none.
  const Stack* entry(std::size_t landmark, bool present) const;

  /// Equal for every pop_until: the topmost symbols at the entries have equal values.
  bool operator==(const History& other) const;

 private:
  std::shared_ptr<const std::vector<Stack>> latest_;  ///< empty stack: never entered
  Stack before_;  ///< at the present state's entry before the latest; empty: no landmark, or its first entry
};

/// The next numbers, unique within a run.
struct NextIds {
  int symbol = 0;
  int write = 1;  ///< of a register
};

struct Configuration {
  StateIndex state = 0;
  Stack stack;
  History history;
  std::shared_ptr<const std::vector<Cell>> memory;  ///< one for each register, in the machine's order; never null
  NextIds next;

  /// Equal in all that decides how the run goes on: ids and sources of values do not count.
  bool same_as(const Configuration& other) const;
};

}  // namespace continua
