// The parts of a step: the applicable transitions, the effect of one of them on the topmost symbol, the other effects
// of the transition and of the state that it enters. Each part sees the head of the configuration alone (state, topmost
// symbol and registers) and ends with at most one change of the stack. So a part can be carried out on a real stack
// (automaton/stepper.h), on many (automaton/exploration.h) or on an unknown one (analysis/acceptance.h).
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "continua/automaton/input.h"
#include "continua/automaton/step_event.h"

namespace continua {

/// The transitions that may fire, and those whose condition does not hold or that others outrank.
struct Applicable {
  std::vector<Candidate> candidates;  ///< those of the highest rank for their input; by alternative, then in file order
  std::vector<Candidate> outranked;   ///< those of a lower rank, in the same order: only force makes them fire
  std::vector<Refused> refused;       ///< in the same order; empty without an account
  double margin = std::numeric_limits<double>::infinity();
};

/// An operation with evaluated contents: nullopt for the JSON null; lists of values for …_each.
struct Change {
  const Operation* operation = nullptr;
  std::vector<std::optional<Cell>> contents;
};

/// The state that a transition enters after all gates are tested, and the operation to perform.
struct Entry {
  StateIndex state = 0;
  const Operation* operation = nullptr;
  bool rejected = false;
  std::vector<GateTest> gates;  ///< conditions are empty without an account
  double margin = std::numeric_limits<double>::infinity();
};

/// A configuration and the inputs under which things happen: one, or alternatives of which one is taken.
/// The input that brought a step about, also once it is used up; empty and nullopt: there was none.
struct InputOrigin {
  std::vector<int> sources;  ///< serials, ascending
  std::optional<double> now_s;
};

class Firing {
 public:
  /// `rules`: the functions behind names. `inputs`: none for ε; the first counts until one is taken. `account` takes
  /// the events; without one nothing is put into words. All must outlive the firing.
  Firing(const Machine& machine, const RuleTable& rules, Configuration configuration, std::span<const Input> inputs,
         const Facts& facts, std::vector<StepEvent>* account)
      : machine_(machine),
        rules_(rules),
        configuration_(std::move(configuration)),
        inputs_(inputs),
        facts_(facts),
        account_(account) {
    if (!inputs_.empty()) take_input(0);
  }

  const Configuration& configuration() const { return configuration_; }
  Configuration take() && { return std::move(configuration_); }

  /// The transitions that take one of the inputs, or without inputs the ε-transitions. No transition takes an input of
  /// confidence 0.
  Applicable applicable();
  /// Fires a transition: its gates, its operation, its effects, the entry of the state. Returns whether ε-transitions
  /// are to be tried now. Returns nothing and changes nothing if the gates refuse one another in a circle.
  std::optional<bool> fire(const Chosen& chosen, Applicable found, int step);
  /// The input is used up: only ε-transitions follow.
  void forget_input();

  /// A value, with its sources: all values read, and the input under way.
  Cell compute(const Term& term);
  /// The same; the applications that the value is made of go to the account.
  Cell derived(const Term& term);

  // The parts of fire(), for callers that keep the stack elsewhere.

  /// Nothing if the gates refuse one another in a circle.
  std::optional<Entry> entry(const Transition& transition);
  Change change(const Operation& operation);
  /// Performs effects. If a rewrite ends them, returns its evaluated change, which is not applied yet.
  std::optional<Change> perform(const std::vector<Effect>& effects);
  void apply(const Change& change);
  void clear_registers(Operation::Kind kind);
  void enter(StateIndex state);

 private:
  void take_input(std::size_t alternative);
  void part_by_rank(Applicable& found, std::size_t first);
  Evaluation evaluate();
  Evaluation::Held look_up(Name name);
  Evaluation::Held read(const Cell& cell);
  void write_register(std::size_t index, Cell cell, std::vector<Cell>& memory);
  bool perform_and_rewrite(const std::vector<Effect>& effects);
  Cell of_type(const Type& type, const std::string& name, Cell cell);
  std::optional<Term> lifted(const Type& type, const Cell& cell);
  void note(StepEvent event);

  // Each returns whether the effect was a rewrite; its change is then in `rewrite_`.
  bool perform_one(const Say& say);
  bool perform_one(const Gesture& gesture);
  bool perform_one(const Act& act);
  bool perform_one(const Remember& remember);
  bool perform_one(const Learn& learn);
  bool perform_one(const Attend& attend);
  bool perform_one(const Forget& forget);
  bool perform_one(const Rewrite& rewrite);
  bool perform_one(const Group& group);
  bool perform_all(const std::vector<Effect>& effects);

  const Machine& machine_;
  const RuleTable& rules_;
  Configuration configuration_;
  std::span<const Input> inputs_;
  const Input* input_ = nullptr;  ///< null once it is used up
  InputOrigin origin_;
  Facts facts_;
  std::vector<StepEvent>* account_;
  std::vector<int> because_;  ///< sources of the value being computed, ascending
  Change rewrite_;
  Derivation* derivation_ = nullptr;             ///< of the value being computed, if it is wanted
  std::unordered_set<Term, TermHash> composed_;  ///< results of applications that went to the account
  Term moment_;                                  ///< value of the name of the moment that was looked up last
};

}  // namespace continua
