// A machine as a pushdown system: the rules for a control with a symbol on top, computed on demand.
//
// Configurations of a machine contain terms, so controls and stack symbols are numbered when they first occur. A
// control is a state with registers and history; between the parts of a transition (automaton/firing.h) it also has the
// remaining work, such as further pops. A rule sees only the topmost symbol and replaces it with a word of symbols.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "continua/automaton/stepper.h"

namespace continua {

/// Replaces the topmost symbol with `word`, topmost first.
struct PushdownRule {
  int control = 0;
  std::vector<int> word;
  std::optional<std::size_t> transition;  ///< the transition that fires here; none while an earlier one continues
};

/// A state of the finite control: the head of a configuration, and the motion under way.
struct PushdownControl {
  enum class Motion {
    none,        ///< nothing is left to do
    effects,     ///< the transition's effects, then the entry of `to`
    entry,       ///< the entry of `to`
    popping,     ///< `count` more symbols, then as `then` says
    flushing,    ///< to the bottom, where `symbol` takes its place
    until,       ///< down to a symbol like `symbol`
    completing,  ///< `change`, whose top `symbol` is popped already, with the symbol below in sight
  };

  Configuration configuration;  ///< without a stack
  Motion motion = Motion::none;
  std::size_t transition = 0;
  StateIndex to = 0;
  int letter = -1;      ///< the value of `input` in effects
  bool settles = true;  ///< ε-transitions are tried now: always, or after a rewrite
  std::size_t count = 0;
  Symbol symbol;
  Change change;
  int then = 0;  ///< control that follows popping, flushing, until, completing
};

/// A symbol of the stack, and whether it is the one at the bottom.
struct PushdownSymbol {
  Symbol symbol;
  bool bottom = false;
};

class PushdownSystem {
 public:
  static constexpr int epsilon = -1;
  /// More controls or symbols than this count as endlessly many: 20,000, and four for each state and transition.
  std::size_t most_values() const { return 20000 + 4 * (machine_->states.size() + machine_->transitions.size()); }

  /// REQUIRES a machine without beliefs. Facts of the world are null.
  explicit PushdownSystem(std::shared_ptr<const Machine> machine);

  int initial_control() const { return initial_control_; }
  const std::vector<int>& initial_stack() const { return initial_stack_; }  ///< topmost first
  int letter(const std::string& symbol);
  /// The rules for a letter or `epsilon`, in file order of the transitions. The reference holds until the next call.
  const std::vector<PushdownRule>& rules(int control, int symbol, int letter);

  /// A transition is complete, the next may begin; `state` is then the machine's.
  bool ready(int control) const {
    return controls_[static_cast<std::size_t>(control)].motion == PushdownControl::Motion::none;
  }
  StateIndex state(int control) const { return controls_[static_cast<std::size_t>(control)].configuration.state; }
  /// Whether the symbol is the bottom symbol of the stack with the values that the machine declares.
  bool is_bare_bottom(int symbol) const { return symbol == bare_bottom_; }
  /// State, registers and this symbol on top, for a `ready` control.
  Configuration head(int control, int symbol) const;
  /// Whether there were more controls or symbols than most_values(), so that rules are missing.
  bool overflowed() const { return overflowed_; }

 private:
  int add(PushdownControl control);
  int add(PushdownSymbol symbol);
  std::vector<PushdownRule> find_rules(int control, int symbol, int letter);
  std::vector<PushdownRule> fire(const PushdownControl& control, int symbol, int letter);
  PushdownRule carry_on(const PushdownControl& control, int symbol);
  Firing firing(const PushdownControl& control, int symbol, int letter) const;
  int after_operation(const PushdownControl& control, std::size_t transition, const Entry& entry, int letter);
  int entering(const Configuration& configuration, StateIndex to, int letter, bool settles);
  PushdownRule moved(const Change& change, const Configuration& before, int symbol, int then);
  PushdownRule still(PushdownControl::Motion motion, std::size_t count, Symbol symbol, int then);
  PushdownRule popped(std::size_t count, int symbol, int then);
  PushdownRule flushed(Symbol kept, int symbol, int then);
  PushdownRule popped_until(Symbol target, int symbol, int then);
  PushdownRule operated(const Change& change, const Stack& stack, bool bottom, std::size_t below, int then);
  const PushdownSymbol& at(int symbol) const { return symbols_[static_cast<std::size_t>(symbol)]; }

  std::shared_ptr<const Machine> machine_;
  Beliefs beliefs_;
  Stepper stepper_;
  std::vector<PushdownControl> controls_;
  std::vector<PushdownSymbol> symbols_;
  std::vector<Input> letters_;
  std::unordered_map<std::string, int> control_ids_, symbol_ids_, letter_ids_;
  struct Head {
    int control, symbol, letter;
    bool operator==(const Head&) const = default;
    struct Hash {
      std::size_t operator()(const Head& head) const;
    };
  };
  std::unordered_map<Head, std::vector<PushdownRule>, Head::Hash> rules_;
  int initial_control_ = 0, bare_bottom_ = 0;
  std::vector<int> initial_stack_;
  bool overflowed_ = false;
};

}  // namespace continua
