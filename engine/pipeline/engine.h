// The parts of the engine that stay the same while a run goes on: what every stage of the pipeline is made with.
#pragma once

#include <memory>

#include "continua/automaton/exploration.h"
#include "continua/behaviour/performance.h"
#include "continua/moves/offer.h"
#include "continua/pipeline/engine_state.h"

namespace continua {

/// A value: every copy does the same, and shares what is large.
struct Engine {
  std::shared_ptr<const Machine> machine;
  std::shared_ptr<const Language> language;  ///< may be null for a machine without a lexicon
  Perspective perspective = Perspective::human;
  FusionWindow window;
  RuleTable rules;  ///< what words compute: functions of the language, facts of the world
  Stepper stepper;
  Explorer explorer;
  Performer performer;
};

/// `language`: what the machine understands words and gestures by; REQUIRED if the machine names a lexicon.
/// `most_branches`: so many configurations are carried along under `explore`.
Engine engine_of(std::shared_ptr<const Machine> machine, std::shared_ptr<const Language> language,
                 Perspective perspective, std::size_t most_branches);

/// The words that a run can begin with in this world.
KnownWords first_words(const Engine& engine, const WorldSnapshot& world);

/// By what words are understood now; none for a machine without a lexicon. The engine must outlive it.
std::optional<Understanding> understanding_of(const Engine& engine, const EngineState& state);

/// What holds in the state and the world; both must outlive the facts.
Facts facts_of(EngineState& state, const WorldSnapshot& world);

/// The dialogue as it stands; all three must outlive it.
Dialogue dialogue_of(const Engine& engine, EngineState& state, const WorldSnapshot& world);

/// The gestures that the engine knows by what they say; nullptr: by their names alone.
const GestureCatalogue* gestures_of(const Engine& engine);

}  // namespace continua
