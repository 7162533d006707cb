#include "continua/automaton/stack_operation.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/core/result.h"

namespace continua {
namespace {

// The work of one operation on a stack that always keeps a bottom symbol.
class Worker {
 public:
  Worker(const Machine& machine, const Configuration& before) : machine_(machine) {
    result_.stack = before.stack;
    result_.next_symbol = before.next.symbol;
  }

  void push(Symbol symbol) {
    const int id = result_.next_symbol++;
    for (auto& cell : symbol)
      if (cell.source == 0 && !cell.because.empty()) cell.source = source_of_symbol(id);
    result_.stack = result_.stack.push(std::move(symbol), id);
    result_.made.push_back(result_.stack);
  }

  // The bottom symbol stays.
  void pop() {
    if (result_.stack.depth() > 1) result_.stack = result_.stack.pop();
  }

  // Takes the topmost symbol off even when it is the last, for a push that follows.
  Symbol take() {
    Symbol top = result_.stack.top();
    result_.stack = result_.stack.pop();
    return top;
  }

  void flush(const Operation& operation) {
    Symbol kept = bottom_symbol(machine_);
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (machine_.slots[i].persists) kept[i] = result_.stack.top()[i];
    for (const auto& content : operation.contents) kept[content.slot] = bottom_symbol(machine_)[content.slot];
    result_.stack = Stack();
    push(std::move(kept));
  }

  void pop_until(const Operation& operation, const Configuration& before) {
    const auto landmark = machine_.landmark[operation.state];
    require(landmark.has_value(), "a state that a pop_until names is a landmark");
    const Stack* entry = before.history.entry(*landmark, before.state == operation.state);
    if (!entry) return flush(operation);
    while (result_.stack.depth() > 1 && !same_values(result_.stack.top(), entry->top()))
      result_.stack = result_.stack.pop();
  }

  // Completes `symbol` by the rule of the 2018 system: a null slot that was not cleared takes the value below.
  Symbol completed(Symbol symbol, const std::vector<bool>& cleared) const {
    if (!machine_.rewrite_below || result_.stack.empty()) return symbol;
    for (std::size_t i = 0; i < symbol.size(); ++i)
      if (symbol[i].value.is_null() && !cleared[i]) symbol[i] = result_.stack.top()[i];
    return symbol;
  }

  const Machine& machine_;
  OperationResult result_;
};

}  // namespace

Symbol bottom_symbol(const Machine& machine) { return machine.bottom; }

OperationResult apply_operation(const Operation& operation, const std::vector<std::optional<Cell>>& contents,
                                const Machine& machine, const Configuration& before) {
  using Kind = Operation::Kind;
  Worker worker(machine, before);
  std::vector<bool> cleared(machine.slots.size(), false);
  const bool each = operation.kind == Kind::push_each || operation.kind == Kind::rewrite_each;

  // `count`: the number of symbols to push. `filled`: the k-th symbol, with the values of the mentioned slots.
  std::size_t count = each ? 0 : 1;
  bool first = true;
  for (std::size_t i = 0; i < contents.size(); ++i) {
    if (!contents[i]) cleared[operation.contents[i].slot] = true;
    if (!each || !contents[i]) continue;
    const auto& list = contents[i]->value;
    const std::size_t size = list.kind() == Term::Kind::list ? list.elements().size() : 0;
    if (!first && size != count)
      worker.result_.trouble = fmt::format("lists of different length in {}: {} and {}", operation.source, count, size);
    count = first ? size : std::min(count, size);
    first = false;
  }
  const auto filled = [&](Symbol symbol, std::size_t k) {
    for (std::size_t i = 0; i < contents.size(); ++i) {
      auto& cell = symbol[operation.contents[i].slot];
      if (!contents[i])
        cell = {empty_value(machine.slots[operation.contents[i].slot].type), {}};
      else if (each)
        cell = {contents[i]->value.elements()[k], contents[i]->because};
      else
        cell = *contents[i];
    }
    return symbol;
  };

  switch (operation.kind) {
    case Kind::none:
      break;
    case Kind::push:
    case Kind::push_each:
      for (std::size_t k = 0; k < count; ++k) worker.push(filled(worker.result_.stack.top(), k));
      break;
    case Kind::pop:
      for (std::size_t k = 0; k < operation.count && worker.result_.stack.depth() > 1; ++k) worker.pop();
      break;
    case Kind::rewrite:
    case Kind::rewrite_each: {
      if (operation.keeps_stack) break;
      const Symbol old = worker.take();
      for (std::size_t k = 0; k < count; ++k) worker.push(worker.completed(filled(old, k), cleared));
      if (worker.result_.stack.empty()) worker.push(bottom_symbol(machine));
      break;
    }
    case Kind::flush:
      worker.flush(operation);
      break;
    case Kind::pop_until:
      worker.pop_until(operation, before);
      break;
  }
  return std::move(worker.result_);
}

}  // namespace continua
