// One step of the automaton: an input is offered, the applicable transitions are found, one is chosen and fired, then
// ε-transitions until none applies (semantics §1). Everything that happened comes back as a list of events; nothing is
// written or drawn anywhere else.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "automaton/machine.h"
#include "core/random.h"
#include "term/evaluate.h"

namespace continua {

/// What the automaton is offered.
struct Input {
  int serial = 0;  ///< names the input in `because`
  std::string symbol;
  Term target, said;  ///< payload: loc, text; null where it has none
  double confidence = 1;
  double now_s = 0;
};

struct Refused {
  std::size_t transition = 0;
  std::string reason;  ///< the first part of its condition that does not hold, with the values it saw
};

struct GateTest {
  StateIndex state = 0;
  std::string condition;
  bool passed = true;
};

struct Fired {
  std::size_t transition = 0;
  StateIndex from = 0, to = 0;
  std::optional<std::string> input;      ///< nullopt: ε
  const Operation* operation = nullptr;  ///< the machine's; the gate's where that refused
  std::vector<Candidate> candidates;
  std::vector<Refused> refused;
  std::optional<GateTest> gate;
  double probability = 1;      ///< the chosen candidate's share of all weights
  std::optional<double> draw;  ///< under Choice::sample, with more than one candidate
  int stack = 0;
  std::size_t depth = 0;
  double margin = 0;  ///< infinity when nothing was compared
};

struct MadeSymbol {
  int id = 0;
  std::optional<int> below;
  Symbol symbol;
};
struct Rewrote {
  StateIndex state = 0;
  const Operation* operation = nullptr;
  int stack = 0;
  std::size_t depth = 0;
};
struct Applied {
  Application application;
  std::vector<int> because;
};
struct Said {
  std::string text;
  std::vector<int> because;
};
struct Gestured {
  Term term;
  std::vector<int> because;
};
struct Acted {
  Term term;
  std::vector<int> because;
};
struct Remembered {
  std::size_t index = 0;
  Term value;
};
struct RefusedInput {
  StateIndex state = 0;
  std::string input, reason;
  std::vector<Refused> refused;
};
/// Something in the machine that cannot be carried out as written, such as an ε-cycle.
struct Trouble {
  std::string message;
};

using StepEvent =
    std::variant<Fired, MadeSymbol, Rewrote, Applied, Said, Gestured, Acted, Remembered, RefusedInput, Trouble>;

struct Step {
  Configuration after;
  std::vector<StepEvent> events;  ///< in the order in which they happened; a symbol before what puts it on the stack
};

class Stepper {
 public:
  /// `methods` are facts of the world, read anew at every step; they must outlive the stepper.
  Stepper(std::shared_ptr<const Machine> machine, const Rules& methods);

  const Machine& machine() const { return *machine_; }

  /// The configuration in which a run begins: start state, the bottom symbol (every slot empty), registers as declared;
  /// then ε-transitions, where the machine always tries them.
  Step begin(const Beliefs& beliefs, Choice choice, Random& random);

  /// Offers an input. If no transition takes it the configuration stays and the events end with RefusedInput.
  Step step(const Configuration& before, const Input& input, const Beliefs& beliefs, Choice choice, Random& random);

  /// The value of a term of the machine in a configuration.
  Term value(const Term& term, const Configuration& configuration, const Input& input, const Beliefs& beliefs);

 private:
  class Run;

  std::shared_ptr<const Machine> machine_;
  std::vector<const Rules*> rules_;
  Rules own_rules_;                   ///< is_input, certainty, wording, tables: read `beliefs_`
  const Beliefs* beliefs_ = nullptr;  ///< those of the step under way
};

}  // namespace continua
