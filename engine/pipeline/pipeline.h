// The engine: the human's events go in, the avatar's thoughts, words and acts come out. Pipeline joins the stages, each
// a function from values to values with a header of its own: perceive → fuse → understand (moves/offer.h) → believe →
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

/// Time passes with each call; it never goes back. An event is received; percepts that are then complete, alone or with
/// their counterparts, are attended to, one after the other. A value: copies behave alike.
class Pipeline {
 public:
  /// `language`: the machine's words and gestures; REQUIRED if the machine names a lexicon. `most_branches`: so many
  /// configurations are carried along under `explore`.
  Pipeline(std::shared_ptr<const Machine> of_machine, std::shared_ptr<const Language> language, Perspective perspective,
           std::size_t most_branches = default_most_branches)
      : engine_(engine_of(std::move(of_machine), std::move(language), perspective, most_branches)) {}

  /// Before the first input; the chooser's policy decides for the whole run. `world` is the world that the machine may
  /// read, `learned` are earlier lessons.
  Tick begin(Chooser chooser, const WorldSnapshot& world, Learned learned = {}) const;

  /// Instead of `begin`: goes on with a run that another pipeline, of the machine `was`, has begun. The state goes over
  /// by names: state, slots and registers of the automaton by the rules of automaton/carry_over.h, certainties by
  /// concept; lessons, waiting percepts and acts under way as they are. Nothing happens by it. The chooser goes on as
  /// the state has it; the caller may change it before.
  Result<EngineState> take_over(EngineState state, const Machine& was, const WorldSnapshot& world) const;

  /// Something happened, and is known at `world.t` or at its own time if that is later.
  Tick receive(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) const;
  /// Nothing happened up to `now`: percepts that waited for so long are complete.
  Tick wake(const EngineState& before, SimTime now) const;
  /// When to wake at the latest; nullopt if nothing waits.
  std::optional<SimTime> due(const EngineState& state) const { return state.fusion.due(); }
  /// Attends to the first of EngineState::complete. REQUIRES that there is one.
  Tick attend(const EngineState& before, const WorldSnapshot& world) const;

  /// Receives an event and attends to all that is complete then.
  Tick tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) const;
  /// The body's reports, and their consequences: the next steps of acts and, where the machine knows the ends of acts
  /// as inputs, its transitions for them.
  Tick reported(const EngineState& before, const std::vector<ActReport>& reports, const WorldSnapshot& world) const;

  /// Another avatar was observed to do something else after an input than the engine did between `before` and `after`.
  /// The configuration becomes the one that its moves imply (Machine::implied), or the one before if it did nothing;
  /// the avatar has said and heard the observed words. Where no row holds, the engine's own configuration stays.
  Tick corrected(const EngineState& before, const EngineState& after, const InputEvent& event,
                 const ObservedMoves& observed, const WorldSnapshot& world) const;

  /// Nothing more happens: all that waits is attended to, as it is.
  Tick settle(const EngineState& before, const WorldSnapshot& world) const;

  const Machine& machine() const { return *engine_.machine; }

 private:
  struct Answered {
    Tick tick;
    std::size_t taken = 0;  ///< which of the offers or inputs the automaton took
  };

  Answered answer(EngineState state, const std::vector<Offer>& offers, const WorldSnapshot& world) const;
  Answered answer(EngineState state, std::span<const Input> inputs, const WorldSnapshot& world) const;
  Tick act(EngineState state, const WorldSnapshot& world) const;
  Tick attend_all(Tick all, const WorldSnapshot& world) const;

  Engine engine_;
};

}  // namespace continua
