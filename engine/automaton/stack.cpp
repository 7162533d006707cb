#include "continua/automaton/stack.h"

#include <algorithm>

#include "continua/core/result.h"

namespace continua {

bool same_values(const Symbol& a, const Symbol& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Cell& x, const Cell& y) { return x.value == y.value; });
}

struct Stack::Node {
  Symbol symbol;
  int id;
  Stack below;
  std::size_t depth;

  // Unlinks the nodes that only this one holds, one by one: destroying a long stack must not recurse.
  ~Node() {
    auto next = std::move(below.node_);
    while (next && next.use_count() == 1) next = std::move(const_cast<Node*>(next.get())->below.node_);
  }
};

std::size_t Stack::depth() const { return node_ ? node_->depth : 0; }

const Symbol& Stack::top() const {
  require(!empty(), "top of an empty stack");
  return node_->symbol;
}

int Stack::id() const {
  require(!empty(), "id of an empty stack");
  return node_->id;
}

std::optional<int> Stack::id_below() const {
  require(!empty(), "id below the top of an empty stack");
  return node_->below.empty() ? std::nullopt : std::optional(node_->below.id());
}

Stack Stack::pop() const {
  require(!empty(), "pop of an empty stack");
  return node_->below;
}

Stack Stack::push(Symbol symbol, int id) const {
  Stack pushed;
  pushed.node_ = std::make_shared<const Node>(Node{std::move(symbol), id, *this, depth() + 1});
  return pushed;
}

bool Stack::operator==(const Stack& other) const {
  if (depth() != other.depth()) return false;
  const Node* a = node_.get();
  const Node* b = other.node_.get();
  for (; a != b; a = a->below.node_.get(), b = b->below.node_.get())
    if (!same_values(a->symbol, b->symbol)) return false;
  return true;
}

}  // namespace continua
