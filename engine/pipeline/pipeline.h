// The engine: what the human did goes in, what the avatar thinks, says and does comes out. Every stage in order, on
// values: perception → fusion → understanding → automaton → behaviour. The shortest tour of the engine
// (engine/README.md).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "continua/facts/methods.h"
#include "continua/moves/understanding.h"
#include "continua/pipeline/discourse.h"
#include "continua/pipeline/engine_state.h"

namespace continua {

inline constexpr std::size_t default_most_branches = 64;

/// Time passes with each call; it never goes back. What happened is received; what is complete then, alone or with its
/// counterpart, is attended to, one after the other.
class Pipeline {
 public:
  /// `language`: what the machine understands words and gestures by; REQUIRED if the machine names a lexicon.
  /// `most_branches`: so many configurations are carried along under `explore`.
  Pipeline(std::shared_ptr<const Machine> machine, std::shared_ptr<const Language> language, Perspective perspective,
           std::size_t most_branches = default_most_branches);

  /// Before the first input; the chooser's policy decides for the whole run. `world` is what the machine may read,
  /// `learned` what was taught before.
  Tick begin(Chooser chooser, const WorldSnapshot& world, Learned learned = {});

  /// Instead of `begin`: goes on with a run that another pipeline, of the machine `was`, has begun. The state goes over
  /// by names: state, slots and registers of the automaton as automaton/carry_over.h has it, certainties by concept;
  /// what was taught, what waits and what is being done as they are. Nothing happens by it. The chooser goes on as the
  /// state has it; the caller may change it before.
  Result<EngineState> take_over(EngineState state, const Machine& was, const WorldSnapshot& world);

  /// Something happened, and is known at `world.t` or at its own time if that is later.
  Tick receive(const EngineState& before, const InputEvent& event, const WorldSnapshot& world);
  /// Nothing happened up to `now`: what waited for so long is complete.
  Tick wake(const EngineState& before, SimTime now);
  /// When to wake at the latest; nothing waits if there is none.
  std::optional<SimTime> due(const EngineState& state) const { return state.fusion.due(); }
  /// Attends to the first of EngineState::complete. REQUIRES that there is one.
  Tick attend(const EngineState& before, const WorldSnapshot& world);

  /// Receives an event and attends to all that is complete then.
  Tick tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world);
  /// What the body reports, and what follows from it: the next steps of acts, and where the machine knows the ends of
  /// acts as inputs, what it makes of them.
  Tick reported(const EngineState& before, const std::vector<ActReport>& reports, const WorldSnapshot& world);

  /// Another avatar was observed to do something else after an input than the engine did between `before` and `after`:
  /// the configuration is the one that its moves imply (Machine::implied), or the one before if it did nothing; the
  /// avatar has said and heard what was observed. Where no row holds the engine's own configuration stays.
  Tick corrected(const EngineState& before, const EngineState& after, const InputEvent& event,
                 const ObservedMoves& observed, const WorldSnapshot& world);

  /// Nothing more happens: all that waits is attended to, as it is.
  Tick settle(const EngineState& before, const WorldSnapshot& world);

  const Machine& machine() const { return *machine_; }

 private:
  struct Heard;

  void begin(EngineState& state, std::vector<EngineEvent>& events);
  void open_vocabulary(const WorldSnapshot& world);
  void keep_up(const Learned& learned);
  Tick attended(Tick tick, const WorldSnapshot& world);
  Percept percept_of(const EngineState& state, const InputEvent& event, int serial) const;
  bool is_confident(const InputEvent& event) const;
  std::string kind_of(const InputEvent& event, const Learned& learned) const;
  std::string symbol(const InputEvent& event, const Learned& learned) const;
  Discourse discourse_now(const EngineState& state, const Input& input, const WorldSnapshot& world);

  // pipeline_moves.cpp: an ensemble as moves
  void hear(EngineState& state, const Ensemble& ensemble, const WorldSnapshot& world, std::vector<EngineEvent>& events);
  void see(EngineState& state, const Ensemble& ensemble, const WorldSnapshot& world, std::vector<EngineEvent>& events);
  void follow(EngineState& state, const InputEvent& sample, int serial, const WorldSnapshot& world,
              std::vector<EngineEvent>& events);
  std::vector<Taker> takers(const Utterance& utterance, const InputEvent& event) const;
  std::vector<std::pair<WordSpan, Deixis>> shown(const Ensemble& ensemble, const InputEvent& event,
                                                 const Utterance& utterance) const;
  std::vector<Bound> bound(const Ensemble& ensemble) const;
  Heard heard(const EngineState& state, const Ensemble& ensemble, std::size_t alternative, const WorldSnapshot& world);
  Heard seen(const EngineState& state, const Ensemble& ensemble, std::size_t alternative, const WorldSnapshot& world);
  void understand(Heard& heard, std::size_t fragment, const EngineState& state, const WorldSnapshot& world);
  Term said_by(const InputEvent& gesture, const Learned& learned) const;
  std::vector<int> because_of(const Heard& heard, const EngineState& state) const;
  std::size_t offer_all(EngineState& state, std::vector<Heard>& heard, std::vector<EngineEvent>& events);

  std::size_t offer(EngineState& state, std::span<const Input> inputs, std::vector<EngineEvent>& events);
  void step(EngineState& state, std::span<const Input> inputs, std::vector<EngineEvent>& events);
  void explored(EngineState& state, ExplorationStep step, std::vector<EngineEvent>& events);
  void update_beliefs(EngineState& state, const Input& input, std::vector<EngineEvent>& events);
  void behave(EngineState& state, std::vector<StepEvent> steps, std::vector<EngineEvent>& events);

  // acting.cpp: what the body is told
  void gesture(EngineState& state, const Term& gesture, std::vector<EngineEvent>& events);
  void perform(EngineState& state, const WorldSnapshot& world, std::vector<EngineEvent>& events);

  std::shared_ptr<const Machine> machine_;
  FusionWindow window_;
  std::shared_ptr<const Language> language_;
  Perspective perspective_;
  Performer performer_;
  Methods methods_;
  RuleTable facts_;
  // Once the run has begun, of machines with a lexicon: without what was taught, and with the words of `taught_`.
  std::optional<Understanding> untaught_, understanding_;
  std::map<std::string, Program, std::less<>> taught_;
  Stepper stepper_;
  Explorer explorer_;
};

}  // namespace continua
