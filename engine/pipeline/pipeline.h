// One tick of the engine: what the human did goes in, what the avatar thinks, says and does comes out. Every stage in
// order, on values: perception → beliefs → automaton → behaviour. The shortest tour of the engine (engine/README.md).
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "automaton/stepper.h"
#include "behaviour/planner.h"
#include "composition/methods.h"
#include "perception/input_event.h"

namespace continua {

/// All that the engine remembers between ticks: a value.
struct EngineState {
  Configuration configuration;
  Beliefs beliefs;
  Random random;
  std::string last_utterance;
  int inputs = 0;  ///< ticks so far; the running number of the latest is its `because`
  int commands = 0;
};

/// The event as an input symbol.
struct Perceived {
  int serial = 0;
  std::string symbol;
};

/// What the body is told, following the Gestured or Acted it carries out.
struct Commanded {
  AvatarCommand command;
  bool gesture = false;
};

/// An act that no command could be made of.
struct Unplanned {
  std::string reason;
};

using EngineEvent = std::variant<Perceived, BeliefChange, StepEvent, Commanded, Unplanned>;

struct Tick {
  EngineState after;
  std::vector<EngineEvent> events;  ///< in the order in which they happened
};

class Pipeline {
 public:
  Pipeline(std::shared_ptr<const Machine> machine, Choice choice, Perspective perspective);

  /// Before the first input. `world` is what the machine may read.
  Tick begin(std::uint64_t seed, const WorldSnapshot& world);
  Tick tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world);

  const Machine& machine() const { return *machine_; }

 private:
  void update_beliefs(EngineState& state, const Input& input, std::vector<EngineEvent>& events);
  void behave(EngineState& state, std::vector<StepEvent> steps, std::vector<EngineEvent>& events);

  std::shared_ptr<const Machine> machine_;
  Choice choice_;
  Perspective perspective_;
  Methods methods_;
  Stepper stepper_;
};

}  // namespace continua
