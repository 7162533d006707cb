#include "automaton/configuration.h"

namespace continua {

struct History::Node {
  StateIndex state;
  Stack stack;
  std::shared_ptr<const Node> older;

  // As in Stack: no recursion over the length of a run.
  ~Node() {
    auto next = std::move(older);
    while (next && next.use_count() == 1) next = std::move(const_cast<Node*>(next.get())->older);
  }
};

History History::entered(StateIndex state, Stack stack) const {
  History grown;
  grown.newest_ = std::make_shared<const Node>(Node{state, std::move(stack), newest_});
  return grown;
}

const Stack* History::previous(StateIndex state) const {
  if (!newest_) return nullptr;
  for (const Node* entry = newest_->older.get(); entry; entry = entry->older.get())
    if (entry->state == state) return &entry->stack;
  return nullptr;
}

bool Configuration::same_as(const Configuration& other) const {
  return state == other.state && stack == other.stack && same_values(memory, other.memory);
}

}  // namespace continua
