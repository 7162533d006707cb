// The parts of the engine that stay the same during a run. Every stage of the pipeline uses them.
#pragma once

#include <memory>

#include "continua/automaton/exploration.h"
#include "continua/behaviour/performance.h"
#include "continua/moves/offer.h"
#include "continua/pipeline/engine_state.h"

namespace continua {

/// A value: copies behave the same and share the large parts.
struct Engine {
  std::shared_ptr<const Machine> machine;
  std::shared_ptr<const Language> language;  ///< may be null for a machine without a lexicon
  Perspective perspective = Perspective::human;
  FusionWindow window;
  RuleTable rules;  ///< rules for words: functions of the language, facts of the world
  Stepper stepper;
  Explorer explorer;
  Performer performer;
};

/// `language`: the data for understanding words and gestures; REQUIRED if the machine names a lexicon.
/// `most_branches`: the most configurations kept under `explore`.
Engine engine_of(std::shared_ptr<const Machine> machine, std::shared_ptr<const Language> language,
                 Perspective perspective, std::size_t most_branches);

/// The words that are known at the beginning of a run in this world.
KnownWords first_words(const Engine& engine, const WorldSnapshot& world);

/// The understanding of words in this state; none for a machine without a lexicon. The engine must outlive it.
std::optional<Understanding> understanding_of(const Engine& engine, const EngineState& state);

/// The facts of the state and the world; both must outlive them.
Facts facts_of(EngineState& state, const WorldSnapshot& world);

/// The dialogue as it stands; all three must outlive it.
Dialogue dialogue_of(const Engine& engine, EngineState& state, const WorldSnapshot& world);

/// The catalogue of gestures with their meanings; nullptr: gestures are known by their names alone.
const GestureCatalogue* gestures_of(const Engine& engine);

}  // namespace continua
