// The engine on machines as small as those of the naive twin.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "continua/automaton/exploration.h"
#include "reference/naive_automaton.h"
#include "support/machines.h"

namespace continua {

/// As the twin has it: the first slots of each symbol, the bottom first.
inline naive::Stack stack_of(Stack stack) {
  naive::Stack symbols;
  for (; !stack.empty(); stack = stack.pop()) {
    naive::Symbol symbol = naive::bottom;
    for (std::size_t slot = 0; slot < stack.top().size(); ++slot)
      if (const Term& value = stack.top()[slot].value; !value.is_null()) symbol[slot] = value.text_value().at(0);
    symbols.insert(symbols.begin(), symbol);
  }
  return symbols;
}

/// "P -- A-": the state, and the symbols of the stack.
inline std::string state_and_stack(std::size_t state, const naive::Stack& stack) {
  std::string text(1, static_cast<char>('P' + state));
  for (const auto& [symbol, held] : stack) text += {' ', symbol, held};
  return text;
}

inline std::string text_of(const Configuration& configuration) {
  return state_and_stack(configuration.state, stack_of(configuration.stack));
}

template <class Event>
bool has(const std::vector<StepEvent>& events) {
  return std::any_of(events.begin(), events.end(), [](const auto& one) { return std::holds_alternative<Event>(one); });
}

class SmallEngine {
 public:
  /// When exploring, at most `limit` configurations are kept.
  explicit SmallEngine(const std::string& json, std::size_t limit = 400)
      : machine_(machine_of(json)),
        stepper_(machine_, no_facts),
        explorer_(stepper_, limit),
        beliefs_(machine_->beliefs),
        chooser_{machine_->choice, Random(0), {}, 0} {}
  SmallEngine(const SmallEngine&) = delete;

  const Machine& machine() const { return *machine_; }
  Step begin() { return stepper_.begin(facts(), chooser_); }
  Step step(const Configuration& before, const std::vector<naive::Offer>& offers) {
    return stepper_.step(before, inputs(offers), facts(), chooser_);
  }
  Step step(const Configuration& before, char symbol) { return step(before, {{symbol, 1}}); }
  ExplorationStep explore() { return explorer_.begin(facts()); }
  ExplorationStep explore(const Exploration& before, const std::vector<naive::Offer>& offers) {
    return explorer_.step(before, inputs(offers), facts());
  }
  ExplorationStep explore(const Exploration& before, char symbol) { return explore(before, {{symbol, 1}}); }

 private:
  Facts facts() const { return {.beliefs = &beliefs_}; }
  static std::vector<Input> inputs(const std::vector<naive::Offer>& offers) {
    std::vector<Input> inputs(offers.size());
    for (std::size_t i = 0; i < offers.size(); ++i) {
      inputs[i].symbol = std::string(1, offers[i].input);
      inputs[i].confidence = offers[i].confidence;
    }
    return inputs;
  }

  std::shared_ptr<const Machine> machine_;
  Stepper stepper_;
  Explorer explorer_;
  Beliefs beliefs_;
  Chooser chooser_;
};

}  // namespace continua
