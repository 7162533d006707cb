#include "continua/pipeline/taking_over.h"

#include <utility>

#include <fmt/format.h>

#include "continua/automaton/carry_over.h"
#include "continua/core/located_json.h"
#include "continua/pipeline/lessons.h"

namespace continua {

Result<EngineState> taken_over(const Engine& engine, EngineState state, const Machine& was,
                               const WorldSnapshot& world) {
  const Machine& machine = *engine.machine;
  for (const auto& [name, program] : state.learned.programs)
    if (is_taken(name, machine))
      return Error{machine.name, fmt::format("the run was taught the word {}, which means something else in this "
                                             "machine",
                                             in_quotes(name))};
  auto configuration = carried_over(state.configuration, was, machine);
  if (!configuration) return configuration.error();
  state.configuration = std::move(*configuration);
  auto exploration = carried_over(state.exploration, was, machine);
  if (!exploration) return exploration.error();
  state.exploration = std::move(*exploration);
  follow_policy(state.chooser, state.configuration, state.exploration);
  state.beliefs = state.beliefs.carried_over(machine.beliefs);
  state.fusion.use(engine.window);
  state.words = first_words(engine, world);
  return state;
}

}  // namespace continua
