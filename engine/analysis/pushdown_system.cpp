#include "continua/analysis/pushdown_system.h"

#include "continua/automaton/stack_operation.h"
#include "continua/core/result.h"
#include "continua/term/term_text.h"

namespace continua {

using Motion = PushdownControl::Motion;
namespace {

// Appends a text with its length, so that different values have different keys.
void append_key(std::string& key, const std::string& text) { key += std::to_string(text.size()) + ':' + text; }
void append_key(std::string& key, const Symbol& symbol) {
  for (const auto& cell : symbol) append_key(key, print(cell.value));
  key += ';';
}

std::string configuration_key(const Configuration& configuration, std::size_t landmarks) {
  auto key = std::to_string(configuration.state) + '\n';
  append_key(key, *configuration.memory);
  for (std::size_t landmark = 0; landmark < landmarks; ++landmark)
    for (const bool present : {false, true})
      if (const auto* entry = configuration.history.entry(landmark, present)) {
        key += std::to_string(2 * landmark + present) + '\n';
        append_key(key, entry->top());
      }
  return key;
}

// The symbols of a stack above the lowest `below`, the topmost first.
std::vector<Symbol> above(Stack stack, std::size_t below) {
  std::vector<Symbol> symbols;
  for (; stack.depth() > below; stack = stack.pop()) symbols.push_back(stack.top());
  return symbols;
}

}  // namespace

std::size_t PushdownSystem::Head::Hash::operator()(const Head& head) const {
  auto hash = static_cast<std::uint64_t>(head.control);
  for (const int part : {head.symbol, head.letter})
    hash = (hash ^ static_cast<std::uint32_t>(part)) * 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

PushdownSystem::PushdownSystem(std::shared_ptr<const Machine> machine)
    : machine_(std::move(machine)), beliefs_(machine_->beliefs), stepper_(machine_, Rules()) {
  auto initial = stepper_.initial();
  bare_bottom_ = add(PushdownSymbol{bottom_symbol(*machine_), true});
  for (auto& symbol : above(initial.stack, 1)) initial_stack_.push_back(add(PushdownSymbol{std::move(symbol), false}));
  initial_stack_.push_back(bare_bottom_);
  initial.stack = Stack();
  PushdownControl control;
  control.configuration = std::move(initial);
  control.settles = machine_->epsilon_always;
  initial_control_ = add(std::move(control));
}

int PushdownSystem::letter(const std::string& symbol) {
  const auto [known, fresh] = letter_ids_.emplace(symbol, static_cast<int>(letters_.size()));
  if (fresh) {
    letters_.emplace_back();
    letters_.back().symbol = symbol;
  }
  return known->second;
}

int PushdownSystem::add(PushdownSymbol symbol) {
  std::string key = symbol.bottom ? "bottom\n" : "\n";
  append_key(key, symbol.symbol);
  const auto [known, fresh] = symbol_ids_.emplace(std::move(key), static_cast<int>(symbols_.size()));
  if (fresh) symbols_.push_back(std::move(symbol));
  if (symbols_.size() > most_values()) overflowed_ = true;
  return known->second;
}

int PushdownSystem::add(PushdownControl control) {
  auto key = configuration_key(control.configuration, machine_->landmarks);
  key += std::to_string(static_cast<int>(control.motion)) + (control.settles ? "ε\n" : "\n");
  if (control.motion != Motion::none) {
    for (const auto part : {control.transition, control.to, control.count, static_cast<std::size_t>(control.then)})
      key += std::to_string(part) + '\n';
    key += std::to_string(control.letter) + '\n';
    append_key(key, control.symbol);
    for (const auto& content : control.change.contents) append_key(key, content ? print(content->value) : "");
  }
  const auto [known, fresh] = control_ids_.emplace(std::move(key), static_cast<int>(controls_.size()));
  if (fresh) controls_.push_back(std::move(control));
  if (controls_.size() > most_values()) overflowed_ = true;
  return known->second;
}

Configuration PushdownSystem::head(int control, int symbol) const {
  auto configuration = controls_[static_cast<std::size_t>(control)].configuration;
  configuration.stack = Stack().push(at(symbol).symbol, 0);
  return configuration;
}

const std::vector<PushdownRule>& PushdownSystem::rules(int control, int symbol, int letter) {
  const Head head{control, symbol, letter};
  const auto known = rules_.find(head);
  if (known != rules_.end()) return known->second;
  auto found = overflowed_ ? std::vector<PushdownRule>() : find_rules(control, symbol, letter);
  return rules_.emplace(head, std::move(found)).first->second;
}

std::vector<PushdownRule> PushdownSystem::find_rules(int id, int symbol, int letter) {
  const PushdownControl control = controls_[static_cast<std::size_t>(id)];
  if (control.motion == Motion::none) return fire(control, symbol, letter);
  if (letter != epsilon) return {};
  return {carry_on(control, symbol)};
}

Firing PushdownSystem::firing(const PushdownControl& control, int symbol, int letter) const {
  auto configuration = control.configuration;
  configuration.stack = Stack().push(at(symbol).symbol, 0);
  const Input* input = letter == epsilon ? nullptr : &letters_[static_cast<std::size_t>(letter)];
  return stepper_.firing(std::move(configuration), input, Facts{.beliefs = &beliefs_}, nullptr);
}

std::vector<PushdownRule> PushdownSystem::fire(const PushdownControl& control, int symbol, int letter) {
  std::vector<PushdownRule> rules;
  if (letter == epsilon && !control.settles) return rules;
  auto firing = this->firing(control, symbol, letter);
  for (const auto& candidate : firing.applicable().candidates) {
    const auto& transition = machine_->transitions[candidate.transition];
    const auto entry = firing.entry(transition);
    if (!entry) continue;
    const auto then = after_operation(control, candidate.transition, *entry, letter);
    rules.push_back(moved(firing.change(*entry->operation), control.configuration, symbol, then));
    rules.back().transition = candidate.transition;
  }
  return rules;
}

// The control once the operation is done. Parts that would do nothing are left out.
int PushdownSystem::after_operation(const PushdownControl& control, std::size_t transition, const Entry& entry,
                                    int letter) {
  const bool settles = machine_->epsilon_always || entry.operation->is_rewrite();
  if (entry.rejected || machine_->transitions[transition].effects.empty())
    return entering(control.configuration, entry.state, letter, settles);
  PushdownControl next{control.configuration, Motion::effects, transition, entry.state, letter, settles, 0, {}, {}, 0};
  return add(std::move(next));
}

int PushdownSystem::entering(const Configuration& configuration, StateIndex to, int letter, bool settles) {
  PushdownControl next;
  next.settles = settles;
  next.configuration = configuration;
  if (machine_->states[to].enter.empty() && !machine_->landmark[to]) {
    next.configuration.state = to;
    next.configuration.history = configuration.history.entered(std::nullopt, machine_->landmarks, Stack());
  } else {
    next.motion = Motion::entry;
    next.to = to;
    next.letter = letter;
  }
  return add(std::move(next));
}

PushdownRule PushdownSystem::carry_on(const PushdownControl& control, int symbol) {
  switch (control.motion) {
    case Motion::none:
      break;
    case Motion::effects: {
      auto firing = this->firing(control, symbol, control.letter);
      const auto rewrite = firing.perform(machine_->transitions[control.transition].effects);
      auto after = firing.configuration();
      after.stack = Stack();
      const auto then = entering(after, control.to, control.letter, control.settles || rewrite);
      return rewrite ? moved(*rewrite, after, symbol, then) : PushdownRule{then, {symbol}, {}};
    }
    case Motion::entry: {
      auto firing = this->firing(control, symbol, control.letter);
      firing.enter(control.to);
      const auto rewrite = firing.perform(machine_->states[control.to].enter);
      PushdownControl next;
      next.settles = control.settles || rewrite;
      next.configuration = firing.configuration();
      next.configuration.stack = Stack();
      const auto before = next.configuration;
      const auto then = add(std::move(next));
      return rewrite ? moved(*rewrite, before, symbol, then) : PushdownRule{then, {symbol}, {}};
    }
    case Motion::popping:
      return popped(control.count, symbol, control.then);
    case Motion::flushing:
      return flushed(control.symbol, symbol, control.then);
    case Motion::until:
      return popped_until(control.symbol, symbol, control.then);
    case Motion::completing: {
      const auto stack = Stack().push(at(symbol).symbol, 0).push(control.symbol, 0);
      return operated(control.change, stack, at(symbol).bottom, 0, control.then);
    }
  }
  require(false, "a control that is ready carries nothing on");
  return {};
}

// The rule for a change of a stack with `symbol` on top; `then`: the control that follows.
PushdownRule PushdownSystem::moved(const Change& change, const Configuration& before, int symbol, int then) {
  using Kind = Operation::Kind;
  const auto& operation = *change.operation;
  const bool bottom = at(symbol).bottom;
  const auto single = Stack().push(at(symbol).symbol, 0);
  if (operation.kind == Kind::pop) return popped(operation.count, symbol, then);
  const Stack* target = nullptr;
  if (operation.kind == Kind::pop_until)
    target = before.history.entry(*machine_->landmark[operation.state], before.state == operation.state);
  if (target) return popped_until(target->top(), symbol, then);
  if (operation.kind == Kind::flush || operation.kind == Kind::pop_until) {
    Configuration alone;
    alone.stack = single;
    return flushed(apply_operation(operation, change.contents, *machine_, alone).stack.top(), symbol, then);
  }
  if (bottom) return operated(change, single, true, 0, then);
  if (operation.is_rewrite() && machine_->rewrite_below && !operation.keeps_stack) {
    PushdownControl completing;
    completing.configuration = before;
    completing.motion = Motion::completing;
    completing.symbol = at(symbol).symbol;
    completing.change = change;
    completing.then = then;
    return {add(std::move(completing)), {}, {}};
  }
  // The symbol below does not matter here: any symbol may stand for it.
  return operated(change, single.push(at(symbol).symbol, 0), false, 1, then);
}

// The operation on a real stack, whose lowest `below` symbols only stand for unseen ones.
PushdownRule PushdownSystem::operated(const Change& change, const Stack& stack, bool bottom, std::size_t below,
                                      int then) {
  Configuration before;
  before.stack = stack;
  const auto after = apply_operation(*change.operation, change.contents, *machine_, before).stack;
  PushdownRule rule{then, {}, {}};
  auto symbols = above(after, below);
  for (std::size_t i = 0; i < symbols.size(); ++i)
    rule.word.push_back(add(PushdownSymbol{std::move(symbols[i]), bottom && i + 1 == symbols.size()}));
  return rule;
}

// The rule that pops the topmost symbol while the motion goes on.
PushdownRule PushdownSystem::still(Motion motion, std::size_t count, Symbol symbol, int then) {
  PushdownControl rest;
  rest.configuration.memory = controls_[static_cast<std::size_t>(then)].configuration.memory;
  rest.motion = motion;
  rest.count = count;
  rest.symbol = std::move(symbol);
  rest.then = then;
  return {add(std::move(rest)), {}, {}};
}

PushdownRule PushdownSystem::popped(std::size_t count, int symbol, int then) {
  if (at(symbol).bottom) return {then, {symbol}, {}};
  if (count == 1) return {then, {}, {}};
  return still(Motion::popping, count - 1, {}, then);
}

PushdownRule PushdownSystem::flushed(Symbol kept, int symbol, int then) {
  if (at(symbol).bottom) return {then, {add(PushdownSymbol{std::move(kept), true})}, {}};
  return still(Motion::flushing, 0, std::move(kept), then);
}

PushdownRule PushdownSystem::popped_until(Symbol target, int symbol, int then) {
  if (at(symbol).bottom || same_values(at(symbol).symbol, target)) return {then, {symbol}, {}};
  return still(Motion::until, 0, std::move(target), then);
}

}  // namespace continua
