#include "continua/pipeline/engine.h"

#include <utility>

#include "continua/core/result.h"
#include "continua/facts/world_facts.h"

namespace continua {
namespace {

// Without fusion no event waits, but words still take a pointing that was made before them.
FusionWindow window_of(const Machine& machine) {
  if (!machine.fusion) return {FusionWindow().before_s, 0, 0, 0, 0};
  const auto& [before_s, after_s, lateness_s, pause_s, together_s] = *machine.fusion;
  return {before_s, after_s, lateness_s, pause_s, together_s};
}

}  // namespace

Engine engine_of(std::shared_ptr<const Machine> machine, std::shared_ptr<const Language> language,
                 Perspective perspective, std::size_t most_branches) {
  require(machine->lexicon.empty() || language, "a machine with a lexicon needs a language");
  const Catalogue* voxemes = language ? language->voxemes.get() : nullptr;
  const RaisingRules* raising = language ? &language->raising : nullptr;
  const WorldFacts facts(perspective, voxemes);
  const Stepper stepper(machine, facts.rules(), raising);
  return {.machine = machine,
          .language = std::move(language),
          .perspective = perspective,
          .window = window_of(*machine),
          .rules = RuleTable({&term_rules(), &facts.rules()}, raising),
          .stepper = stepper,
          .explorer = Explorer(stepper, most_branches),
          .performer = Performer(voxemes, perspective)};
}

KnownWords first_words(const Engine& engine, const WorldSnapshot& world) {
  return engine.machine->lexicon.empty() ? KnownWords() : known_words(engine.language->lexicon, world);
}

std::optional<Understanding> understanding_of(const Engine& engine, const EngineState& state) {
  if (!state.words.all) return std::nullopt;
  return Understanding(*engine.language, state.words.all, engine.rules);
}

Facts facts_of(EngineState& state, const WorldSnapshot& world) {
  return {&world, &state.chooser.random, &state.learned, &state.beliefs, &state.looked};
}

Dialogue dialogue_of(const Engine& engine, EngineState& state, const WorldSnapshot& world) {
  return {.stepper = engine.stepper,
          .configuration = state.configuration,
          .facts = facts_of(state, world),
          .lessons = state.lessons,
          .window = engine.window,
          .gestures = gestures_of(engine),
          .sign = state.sign,
          .understanding = understanding_of(engine, state)};
}

const GestureCatalogue* gestures_of(const Engine& engine) {
  return engine.language ? engine.language->gestures.get() : nullptr;
}

}  // namespace continua
