#include "continua/pipeline/step.h"

#include <utility>

#include <fmt/format.h>

namespace continua {
namespace {

Stepped stepped(EngineState state, Step step) {
  state.configuration = std::move(step.after);
  return {std::move(state), std::move(step.events), {}, 0};
}

// The avatar follows the leading branch; the other branches are only reported.
Stepped explored(EngineState state, ExplorationStep step) {
  state.exploration = std::move(step.after);
  state.configuration = state.exploration.branches.front().configuration;
  const auto& branches = state.exploration.branches;
  std::vector<EngineEvent> others;
  if (branches.size() > 1 || !step.dropped.empty() || step.merged > 0 || step.pruned > 0) {
    for (auto& made : step.made) others.push_back(std::move(made));
    for (auto& other : step.others)
      for (auto& event : other.events) others.push_back(Branched{other.branch, other.parent, std::move(event)});
    others.push_back(Explored{branches, std::move(step.dropped), step.merged, step.pruned});
  }
  return {std::move(state), std::move(step.events), std::move(others), 0};
}

const Trouble* endless(const std::vector<StepEvent>& events) {
  for (const auto& event : events)
    if (const auto* trouble = std::get_if<Trouble>(&event); trouble && trouble->endless) return trouble;
  return nullptr;
}

// A step that does not come to its end is as if it had not been taken: its input is refused.
Stepped undone(EngineState before, const Trouble& trouble, std::span<const Input> inputs) {
  const RefusedInput refused{before.configuration.state, inputs.front().symbol, trouble.message, {}, inputs.size()};
  return {std::move(before), {trouble, refused}, {}, 0};
}

Stepped stepped_with(const Engine& engine, EngineState state, std::span<const Input> inputs,
                     const WorldSnapshot& world) {
  const Facts facts = facts_of(state, world);
  if (state.chooser.policy == Choice::explore) {
    auto step = engine.explorer.step(state.exploration, inputs, facts);
    return explored(std::move(state), std::move(step));
  }
  const auto chooser = state.chooser;
  auto step = engine.stepper.step(state.configuration, inputs, facts, state.chooser);
  if (const auto* trouble = endless(step.events)) {
    state.chooser = chooser;
    return undone(std::move(state), *trouble, inputs);
  }
  return stepped(std::move(state), std::move(step));
}

bool is_refused(const Stepped& stepped) {
  return !stepped.events.empty() && std::holds_alternative<RefusedInput>(stepped.events.back());
}

// Tells the machine that an input was refused, with all that the input carries. Nothing happens if no transition takes
// that either.
Stepped told_of_refusal(const Engine& engine, Stepped stepped, Input refused, const WorldSnapshot& world) {
  refused.symbol = refused_symbol;
  auto answer = stepped_with(engine, stepped.after, std::span(&refused, 1), world);
  if (is_refused(answer)) return stepped;
  answer.events.insert(answer.events.begin(), stepped.events.begin(), stepped.events.end());
  return answer;
}

}  // namespace

Stepped first_step(const Engine& engine, EngineState state, const WorldSnapshot& world) {
  const Facts facts = facts_of(state, world);
  if (state.chooser.policy == Choice::explore) {
    auto step = engine.explorer.begin(facts);
    return explored(std::move(state), std::move(step));
  }
  auto step = engine.stepper.begin(facts, state.chooser);
  return stepped(std::move(state), std::move(step));
}

std::optional<std::string> too_unsure(const Machine& machine, const std::string& symbol, double confidence) {
  if (confidence < machine.minimum_confidence)
    return fmt::format("confidence {} is below the machine's minimum of {}", confidence, machine.minimum_confidence);
  const auto* thresholds = symbol.empty() ? nullptr : machine.thresholds_of(symbol);
  if (!thresholds || confidence >= thresholds->ignore) return std::nullopt;
  return fmt::format("its confidence {} is below {}: the machine ignores such a '{}'", confidence, thresholds->ignore,
                     symbol);
}

std::optional<Stepped> step_if_taken(const Engine& engine, EngineState state, const Input& input,
                                     const WorldSnapshot& world) {
  Stepped stepped = stepped_with(engine, std::move(state), std::span(&input, 1), world);
  return is_refused(stepped) ? std::nullopt : std::optional(std::move(stepped));
}

Stepped step(const Engine& engine, EngineState state, std::span<const Input> inputs, const WorldSnapshot& world) {
  std::vector<Input> offered;
  std::vector<std::size_t> which;
  std::optional<RefusedInput> unsure;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (engine.machine->ignored.contains(inputs[i].symbol)) continue;
    if (auto why = too_unsure(*engine.machine, inputs[i].symbol, inputs[i].confidence)) {
      if (!unsure)
        unsure = RefusedInput{state.configuration.state, inputs[i].symbol, *std::move(why), {}, inputs.size()};
      continue;
    }
    offered.push_back(inputs[i]);
    which.push_back(i);
  }
  if (offered.empty()) {
    Stepped nothing{std::move(state), {}, {}, 0};
    if (unsure) nothing.events.push_back(*std::move(unsure));
    return nothing;
  }
  Stepped stepped = stepped_with(engine, std::move(state), offered, world);
  if (is_refused(stepped)) stepped = told_of_refusal(engine, std::move(stepped), offered.front(), world);
  stepped.taken = which.front();
  for (const auto& event : stepped.events)
    if (const auto* fired = std::get_if<Fired>(&event); fired && fired->input) {
      stepped.taken = which[fired->alternative];
      break;
    }
  return stepped;
}

}  // namespace continua
