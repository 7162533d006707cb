// Acceptance by the runs above a symbol of the stack. A head is a place in the word, a state and the topmost symbol.
// While something lies on the symbol below, that one plays no part. So it is enough to know the exits of each head: how
// the run can go on until its symbol is gone, whatever is below. A least fixed point over all heads that occur:
// computed anew, round by round, until a round adds nothing.
#include <map>
#include <tuple>

#include "reference/naive_exploration.h"

namespace naive {

namespace {

using Kind = Operation::Kind;

struct Place {
  int at = 0;  ///< symbols of the word read so far
  int state = 0;
  auto operator<=>(const Place&) const = default;
};

struct Head {
  Place place;
  Symbol top;
  auto operator<=>(const Head&) const = default;
};

// The symbol is gone, and so many more are still to be popped.
struct Exit {
  Place place;
  int pops = 0;
  auto operator<=>(const Exit&) const = default;
};

class Tabulation {
 public:
  Tabulation(const Machine& machine, const std::string& word) : machine_(machine), word_(word) {
    lowest_.insert({{0, 0}, bottom});
    do {
      added_ = false;
      for (const auto& head : std::set<Head>(lowest_)) follow(head, true);
      for (const auto& [head, exits] : std::map<Head, std::set<Exit>>(upper_)) follow(head, false);
    } while (added_);
  }

  bool accepts(Acceptance by) const {
    const int end = static_cast<int>(word_.size());
    const auto accepting = [&](const Head& head) {
      return head.place.at == end && machine_.states[head.place.state].accepting;
    };
    for (const auto& head : lowest_)
      if (by == Acceptance::final_state ? accepting(head) : head.place.at == end && head.top == bottom) return true;
    for (const auto& [head, exits] : upper_)
      if (by == Acceptance::final_state && accepting(head)) return true;
    return false;
  }

 private:
  // Everything that can happen next at a head. `lowest`: nothing lies below its symbol.
  void follow(const Head& head, bool lowest) {
    const auto& [at, state] = head.place;
    const Configuration now = {state, {head.top}, {}};
    for (const auto& transition : applicable(machine_, now, std::nullopt)) take(head, lowest, transition, at);
    if (at == static_cast<int>(word_.size())) return;
    for (const auto& transition : applicable(machine_, now, word_[at])) take(head, lowest, transition, at + 1);
  }

  void take(const Head& head, bool lowest, const Transition& transition, int at) {
    const auto way = way_through_gates(machine_, head.top, transition);
    if (!way) return;
    const Place to = {at, way->to};
    const auto& operation = way->operation;
    switch (operation.kind) {
      case Kind::none:
      case Kind::push:
      case Kind::push_each:
        return lay(head, lowest, to, head.top, filled_each(operation, head.top));
      case Kind::pop:
        return pop(head, lowest, to, head.top, operation.count);
      case Kind::rewrite:
      case Kind::rewrite_each: {
        auto symbols = filled_each(operation, head.top);
        if (symbols.empty() && lowest) symbols = {bottom};
        if (symbols.empty()) return pop(head, lowest, to, head.top, 1);
        const Symbol first = symbols[0];
        symbols.erase(symbols.begin());
        return lay(head, lowest, to, first, symbols);
      }
      case Kind::flush:
        return add_lowest({to, flushed(operation.contents[0], head.top)});
      case Kind::pop_until:
        return;
    }
  }

  static Stack filled_each(const Operation& operation, const Symbol& top) {
    Stack symbols;
    for (const auto& content : operation.contents)
      symbols.push_back(filled(content, symbols.empty() ? top : symbols.back(), top));
    return symbols;
  }

  // `symbol` is where `head`'s was, with `pile` on it: the heads and exits once the pile is gone.
  void lay(const Head& head, bool lowest, const Place& to, const Symbol& symbol, const Stack& pile) {
    for (const auto& exit : exits_of(pile, {to, 0})) pop(head, lowest, exit.place, symbol, exit.pops);
  }

  // The ways in which a pile can vanish, of which `exit.pops` are popped at once.
  std::set<Exit> exits_of(Stack pile, const Exit& exit) {
    if (pile.empty()) return {exit};
    const Symbol top = pile.back();
    pile.pop_back();
    if (exit.pops > 0) return exits_of(pile, {exit.place, exit.pops - 1});
    std::set<Exit> all;
    for (const auto& gone : exits_of_head({exit.place, top}))
      for (const auto& last : exits_of(pile, gone)) all.insert(last);
    return all;
  }

  std::set<Exit> exits_of_head(const Head& head) {
    if (!upper_.count(head)) {
      upper_[head];
      added_ = true;
    }
    return upper_[head];
  }

  // In `head`'s place there is now `symbol`, to be popped with others below, or not at all.
  void pop(const Head& head, bool lowest, const Place& to, const Symbol& symbol, int count) {
    if (lowest)
      add_lowest({to, symbol});
    else if (count > 0)
      add_exit(head, {to, count - 1});
    else
      for (const auto& exit : exits_of_head({to, symbol})) add_exit(head, exit);
  }

  void add_lowest(const Head& head) { added_ |= lowest_.insert(head).second; }
  void add_exit(const Head& head, const Exit& exit) { added_ |= upper_[head].insert(exit).second; }

  const Machine& machine_;
  const std::string& word_;
  std::set<Head> lowest_;                 ///< heads that occur at the bottom
  std::map<Head, std::set<Exit>> upper_;  ///< those that occur above something, and how they end
  bool added_ = false;
};

}  // namespace

bool accepts(const Machine& machine, const std::string& word, Acceptance by) {
  return Tabulation(machine, word).accepts(by);
}

}  // namespace naive
