// The stack of the automaton: an immutable list that shares its tail, so a snapshot costs nothing (paper §2.2).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "continua/term/term.h"

namespace continua {

/// A source of a value, as a number: the serial of an input (from 1), or the value of a slot or register that was
/// read, which came of others in its turn. A list of sources is so as long as what one step reads, however long the
/// session. Sources of symbols are odd, those of registers even, all of them negative.
constexpr int source_of_symbol(int id) { return -2 * id - 1; }
constexpr int source_of_write(int number) { return -2 * number; }

/// The value of one slot or register, and its sources, ascending.
struct Cell {
  Term value;
  std::vector<int> because;
  int source = 0;  ///< the number of the value itself; 0: the machine's first value, or one that is not kept yet
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
