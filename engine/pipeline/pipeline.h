// The engine: events of the human go in; the avatar's thoughts, words and acts come out. Pipeline joins the stages,
// each a function from values to values with its own header: perceive → fuse → understand (moves/offer.h) → believe →
// step → behave → act. The shortest tour of the engine (engine/README.md) is pipeline.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "continua/pipeline/engine.h"

namespace continua {

inline constexpr std::size_t default_most_branches = 64;

/// Receives events and attends to ensembles, one after the other, once they are complete. Time never goes back from
/// call to call. A value: copies behave the same.
class Pipeline {
 public:
  /// `language`: the data for understanding words and gestures; REQUIRED if the machine names a lexicon.
  /// `most_branches`: the most configurations kept under `explore`.
  Pipeline(std::shared_ptr<const Machine> of_machine, std::shared_ptr<const Language> language, Perspective perspective,
           std::size_t most_branches = default_most_branches)
      : engine_(engine_of(std::move(of_machine), std::move(language), perspective, most_branches)) {}

  /// Begins a run, before the first input. The chooser's policy holds for the whole run. `world`: the world that the
  /// machine may read. `learned`: lessons of earlier runs.
  Tick begin(Chooser chooser, const WorldSnapshot& world, Learned learned = {}) const;

  /// Instead of begin(): goes on with a run that a pipeline of the machine `was` has begun. State, slots and registers
  /// of the automaton are translated by name (automaton/carry_over.h), certainties by concept. Lessons, waiting events
  /// and acts under way stay. No events result. The state's chooser goes on; the caller may change it before.
  Result<EngineState> take_over(EngineState state, const Machine& was, const WorldSnapshot& world) const;

  /// Receives an event, at `world.t` or at its own time if that is later.
  Tick receive(EngineState before, const InputEvent& event, const WorldSnapshot& world) const;
  /// Whether `a` is to be received before `b`, if both are known at one instant (pipeline/instant.h). Machines without
  /// fusion take events as they are told.
  bool comes_before(const EngineState& state, const InputEvent& a, const InputEvent& b) const;
  /// No event came up to `now`: completes the percepts that need not wait longer, and lets acts go on that need not.
  Tick wake(EngineState before, SimTime now) const;
  /// The latest time to call wake(); none if nothing waits.
  std::optional<SimTime> due(const EngineState& state) const;
  /// Attends to the first of EngineState::complete. REQUIRES that there is one.
  Tick attend(EngineState before, const WorldSnapshot& world) const;

  /// Receives an event and attends to all complete ensembles.
  Tick tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) const;
  /// Takes reports of the body: performs the next steps of acts, and answers ends of acts that are inputs of the
  /// machine.
  Tick reported(EngineState before, const std::vector<ActReport>& reports, const WorldSnapshot& world) const;

  /// Follows another avatar whose observed moves after an input differ from the engine's between `before` and `after`.
  /// The configuration becomes the one that those moves imply (Machine::implied), or the one before if there were none;
  /// the observed utterances count as the avatar's own. If no row holds the engine's own configuration stays.
  Tick corrected(const EngineState& before, const EngineState& after, const InputEvent& event,
                 const ObservedMoves& observed, const WorldSnapshot& world) const;

  /// No more events come: attends to all that waits, as it is.
  Tick settle(const EngineState& before, const WorldSnapshot& world) const;

  const Machine& machine() const { return *engine_.machine; }

 private:
  struct Answered {
    Tick tick;
    std::size_t taken = 0;  ///< number of the offer or input that the automaton took
  };

  bool may_ask(const Ensemble& ensemble, const std::vector<Offer>& offers) const;
  std::vector<std::size_t> doubted(const EngineState& state, const std::vector<Offer>& offers, const Answered& answered,
                                   const WorldSnapshot& world) const;
  std::optional<Tick> ask(const EngineState& state, const Ensemble& ensemble, const std::vector<Offer>& offers,
                          const Answered& answered, const WorldSnapshot& world) const;
  Tick overhear(EngineState state, Percept percept, SimTime now, const WorldSnapshot& world) const;
  Answered answer(EngineState state, const std::vector<Offer>& offers, const WorldSnapshot& world) const;
  Answered answer(EngineState state, std::span<const Input> inputs, const WorldSnapshot& world) const;
  void hold(EngineState& state, const InputEvent& event, SimTime now) const;
  Tick act(EngineState state, const WorldSnapshot& world) const;
  Tick attend_all(Tick all, const WorldSnapshot& world) const;

  Engine engine_;
};

}  // namespace continua
