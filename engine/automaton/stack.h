// The stack of the automaton: an immutable list that shares its tail, so a snapshot costs nothing (paper §2.2).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "continua/term/term.h"

namespace continua {

/// The value of one slot, and the running numbers of the inputs that contributed to it, ascending.
struct Cell {
  Term value;
  std::vector<int> because;
};

/// A stack symbol: one cell for each slot, in the machine's order.
using Symbol = std::vector<Cell>;

/// Equal values slot by slot; their sources do not count.
bool same_values(const Symbol& a, const Symbol& b);

/// A value; copying shares. The empty stack is the default.
class Stack {
 public:
  bool empty() const { return !node_; }
  std::size_t depth() const;

  const Symbol& top() const;            ///< REQUIRES !empty()
  int id() const;                       ///< of the topmost symbol; REQUIRES !empty()
  std::optional<int> id_below() const;  ///< of the symbol below it, if there is one; REQUIRES !empty()
  Stack pop() const;                    ///< REQUIRES !empty()
  /// `id` names the new symbol in the log. It is unique within a run.
  Stack push(Symbol symbol, int id) const;

  /// Equal symbols in the same order; ids do not count.
  bool operator==(const Stack& other) const;

 private:
  struct Node;
  std::shared_ptr<const Node> node_;
};

}  // namespace continua
