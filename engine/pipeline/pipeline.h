// One tick of the engine: what the human did goes in, what the avatar thinks, says and does comes out. Every stage in
// order, on values: perception → beliefs → automaton → behaviour. The shortest tour of the engine (engine/README.md).
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "automaton/exploration.h"
#include "composition/methods.h"
#include "moves/understanding.h"
#include "perception/input_event.h"
#include "pipeline/acting.h"
#include "pipeline/discourse.h"

namespace continua {

/// Where the human pointed last.
struct Pointed {
  Vec3 place_W = Vec3::Zero();
  SimTime t;
  int serial = 0;      ///< of the input that told it
  std::string object;  ///< the likeliest one there, or empty
};

/// All that the engine remembers between ticks: a value.
struct EngineState {
  Configuration configuration;  ///< under `explore` that of the leading branch
  Exploration exploration;      ///< all branches; empty under the other policies
  Beliefs beliefs;
  Chooser chooser;
  std::string last_utterance;
  std::optional<Pointed> pointed;
  int inputs = 0;  ///< ticks so far; the running number of the latest is its `because`
  Performance performance;
  int acts = 0;  ///< asked for so far; the running number of the latest
};

/// The event as an input symbol.
struct Perceived {
  int serial = 0;
  std::string symbol;
  int act = 0;  ///< number of the act whose end it is; 0: it is the human's
};

/// What the input was taken to mean; for each move of an utterance one. What it applied follows, then what the
/// automaton did with it.
struct Understood {
  Move move;
  std::vector<int> because;  ///< serials of the inputs that it draws on
};

/// Under `explore`: what the automaton may be in beside what led to the events before it.
struct Explored {
  std::vector<Branch> branches;
  std::vector<int> dropped;
  int merged = 0, pruned = 0;
};

using EngineEvent = std::variant<Perceived, Understood, BeliefChange, StepEvent, Explored, GestureCommand, Unplanned,
                                 ActStep, ActEnd>;

struct Tick {
  EngineState after;
  std::vector<EngineEvent> events;  ///< in the order in which they happened
};

inline constexpr std::size_t default_most_branches = 64;

/// So long after the human pointed somewhere words still go with it.
inline constexpr double pointing_lasts_s = 2;

class Pipeline {
 public:
  /// `language`: what the machine understands speech by; REQUIRED if the machine names a lexicon. `catalogue`: the
  /// voxemes by which acts are performed; without it, those alone that the body can do itself. `most_branches`: so many
  /// configurations are carried along under `explore`.
  Pipeline(std::shared_ptr<const Machine> machine, std::shared_ptr<const Language> language,
           std::shared_ptr<const Catalogue> catalogue, Perspective perspective,
           std::size_t most_branches = default_most_branches);

  /// Before the first input; the chooser's policy decides for the whole run. `world` is what the machine may read.
  Tick begin(Chooser chooser, const WorldSnapshot& world);
  Tick tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world);
  /// What the body reports, and what follows from it: the next steps of acts, and where the machine knows the ends of
  /// acts as inputs, what it makes of them.
  Tick reported(const EngineState& before, const std::vector<ActReport>& reports, const WorldSnapshot& world);

  const Machine& machine() const { return *machine_; }

 private:
  void begin(EngineState& state, std::vector<EngineEvent>& events);
  void step(EngineState& state, const Input& input, std::vector<EngineEvent>& events);
  void hear(EngineState& state, const InputEvent& event, Input input, const WorldSnapshot& world,
            std::vector<EngineEvent>& events);
  void see(EngineState& state, const InputEvent& event, Input& input, const WorldSnapshot& world,
           std::vector<EngineEvent>& events);
  Discourse discourse_now(const EngineState& state, Input& input, const WorldSnapshot& world);
  void offer(EngineState& state, const Input& input, std::vector<EngineEvent>& events);
  void explored(EngineState& state, ExplorationStep step, std::vector<EngineEvent>& events);
  void update_beliefs(EngineState& state, const Input& input, std::vector<EngineEvent>& events);
  void gesture(EngineState& state, const Term& gesture, std::vector<EngineEvent>& events);
  void perform(EngineState& state, const WorldSnapshot& world, std::vector<EngineEvent>& events);
  void behave(EngineState& state, std::vector<StepEvent> steps, std::vector<EngineEvent>& events);

  std::shared_ptr<const Machine> machine_;
  std::shared_ptr<const Language> language_;
  std::shared_ptr<const Catalogue> catalogue_;
  Perspective perspective_;
  Performer performer_;
  Methods methods_;
  RuleTable facts_;
  std::optional<Understanding> understanding_;  ///< once the run has begun, of machines with a lexicon
  Stepper stepper_;
  Explorer explorer_;
};

}  // namespace continua
