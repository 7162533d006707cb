#include "continua/replay/check/examples.h"

#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/analysis/acceptance.h"
#include "continua/core/located_json.h"
#include "continua/pipeline/pipeline.h"

namespace continua {
namespace {

using Problem = std::optional<std::string>;

Problem problem_of(const RunExample& example, const std::shared_ptr<const Machine>& machine,
                   const std::shared_ptr<const Language>& language) {
  const WorldSnapshot empty_table;
  Pipeline pipeline(machine, language, Perspective::human);
  auto state = pipeline.begin({machine->choice, Random(0), {}, 0}, empty_table).after;
  for (const auto& symbol : example.inputs)
    state = pipeline.settle(pipeline.tick(state, event_of(symbol), empty_table).after, empty_table).after;
  const auto &expected = machine->states[example.ends].name, &found = machine->states[state.configuration.state].name;
  if (expected == found) return std::nullopt;
  return fmt::format("after {} the machine is in {}, expected {}", fmt::join(example.inputs, ", "), found, expected);
}

Problem problem_of(const WordExample& example, const std::shared_ptr<const Machine>& machine,
                   const std::shared_ptr<const Language>&) {
  Acceptance acceptance(machine, example.by_empty_stack ? AcceptBy::empty_stack : AcceptBy::final_state);
  const auto accepted = acceptance.accepts(example.word);
  const auto word = in_quotes(fmt::format("{}", fmt::join(example.word, " ")));
  if (!accepted) return fmt::format("whether {} is accepted: {}", word, accepted.error().text());
  if (*accepted == example.accepted) return std::nullopt;
  return fmt::format("the word {} is {}, expected the opposite", word, *accepted ? "accepted" : "rejected");
}

}  // namespace

std::vector<std::string> broken_examples(const std::shared_ptr<const Machine>& machine,
                                         const std::shared_ptr<const Language>& language) {
  std::vector<std::string> broken;
  for (std::size_t i = 0; i < machine->examples.size(); ++i) {
    const auto problem =
        std::visit([&](const auto& example) { return problem_of(example, machine, language); }, machine->examples[i]);
    if (problem) broken.push_back(fmt::format("example {}: {}", i + 1, *problem));
  }
  return broken;
}

}  // namespace continua
