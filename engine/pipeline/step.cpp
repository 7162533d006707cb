#include "continua/pipeline/step.h"

#include <utility>

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

Stepped step(const Engine& engine, EngineState state, std::span<const Input> inputs, const WorldSnapshot& world) {
  std::vector<Input> offered;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (engine.machine->ignored.contains(inputs[i].symbol)) continue;
    if (inputs[i].confidence < engine.machine->minimum_confidence) continue;
    offered.push_back(inputs[i]);
    which.push_back(i);
  }
  if (offered.empty()) return {std::move(state), {}, {}, 0};
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
