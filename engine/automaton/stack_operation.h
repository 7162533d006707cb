// The operations on a stack, as pure functions of values (SEMANTICS.md §1, Operations).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"

namespace continua {

struct OperationResult {
  Stack stack;
  std::vector<Stack> made;  ///< the stack after each push, in order
  int next_symbol = 0;
  std::string trouble;  ///< a sentence if the operation could not be done as written, else empty
};

/// `contents`: the values of operation.contents, nullopt for the JSON null; lists of values for …_each.
OperationResult apply_operation(const Operation& operation, const std::vector<std::optional<Cell>>& contents,
                                const Machine& machine, const Configuration& before);

/// The symbol at the bottom of every stack.
Symbol bottom_symbol(const Machine& machine);

}  // namespace continua
