#include "pipeline/pipeline.h"

#include <fmt/format.h>

namespace continua {
namespace {

Term point_term(const Vec3& p_W) { return Term::point(p_W.x(), p_W.y(), p_W.z()); }

Input to_input(const InputEvent& event, int serial) {
  Input input;
  input.serial = serial;
  input.symbol = symbol_of(event);
  if (const auto place = place_of(event)) input.target = point_term(*place);
  if (event.modality == Modality::speech) input.said = Term::text(event.text);
  input.confidence = event.confidence;
  input.now_s = event.t.seconds();
  return input;
}

}  // namespace

Pipeline::Pipeline(std::shared_ptr<const Machine> machine, Perspective perspective, std::size_t most_branches)
    : machine_(std::move(machine)),
      perspective_(perspective),
      methods_(perspective),
      stepper_(machine_, methods_.rules()),
      explorer_(stepper_, most_branches) {}

Tick Pipeline::begin(Chooser chooser, const WorldSnapshot& world) {
  Tick tick{EngineState{{}, {}, Beliefs(machine_->beliefs), std::move(chooser), "", 0, 0}, {}};
  methods_.see(&world, &tick.after.chooser.random);
  begin(tick.after, tick.events);
  return tick;
}

void Pipeline::begin(EngineState& state, std::vector<EngineEvent>& events) {
  if (state.chooser.policy == Choice::explore) return explored(state, explorer_.begin(state.beliefs), events);
  Step step = stepper_.begin(state.beliefs, state.chooser);
  state.configuration = std::move(step.after);
  behave(state, std::move(step.events), events);
}

void Pipeline::step(EngineState& state, const Input& input, std::vector<EngineEvent>& events) {
  if (state.chooser.policy == Choice::explore)
    return explored(state, explorer_.step(state.exploration, input, state.beliefs), events);
  Step step = stepper_.step(state.configuration, input, state.beliefs, state.chooser);
  state.configuration = std::move(step.after);
  behave(state, std::move(step.events), events);
}

// The avatar does what the leading branch does; of the others only what they are is told.
void Pipeline::explored(EngineState& state, ExplorationStep step, std::vector<EngineEvent>& events) {
  state.exploration = std::move(step.after);
  state.configuration = state.exploration.branches.front().configuration;
  behave(state, std::move(step.events), events);
  if (state.exploration.branches.size() == 1 && step.dropped.empty() && step.merged == 0 && step.pruned == 0) return;
  for (auto& made : step.made) events.push_back(std::move(made));
  events.push_back(Explored{state.exploration.branches, std::move(step.dropped), step.merged, step.pruned});
}

Tick Pipeline::tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) {
  Tick tick{before, {}};
  EngineState& state = tick.after;
  methods_.see(&world, &state.chooser.random);

  const Input input = to_input(event, ++state.inputs);
  tick.events.push_back(Perceived{input.serial, input.symbol});
  if (input.confidence < machine_->minimum_confidence) {
    tick.events.push_back(StepEvent(RefusedInput{state.configuration.state,
                                                 input.symbol,
                                                 fmt::format("confidence {} is below the machine's minimum of {}",
                                                             input.confidence, machine_->minimum_confidence),
                                                 {}}));
    return tick;
  }
  update_beliefs(state, input, tick.events);
  step(state, input, tick.events);
  return tick;
}

void Pipeline::update_beliefs(EngineState& state, const Input& input, std::vector<EngineEvent>& events) {
  const auto note = [&](const std::vector<BeliefChange>& changes) {
    events.insert(events.end(), changes.begin(), changes.end());
  };
  for (const auto& answer : machine_->beliefs.answers) {
    if (!answer.inputs.contains(input.symbol)) continue;
    if (answer.when && !stepper_.value(*answer.when, state.configuration, input, state.beliefs).value.is_true())
      continue;
    const auto about = stepper_.value(answer.about, state.configuration, input, state.beliefs).value;
    if (about.kind() != Term::Kind::text) continue;
    note(answer.set ? state.beliefs.set(about.text_value(), *answer.set) : state.beliefs.raise(about.text_value()));
  }
  note(state.beliefs.raise(input.symbol));
}

// What the automaton emitted becomes words and commands; what the avatar says, it hears itself.
void Pipeline::behave(EngineState& state, std::vector<StepEvent> steps, std::vector<EngineEvent>& events) {
  for (auto& step : steps) {
    if (const auto* said = std::get_if<Said>(&step)) {
      const std::string words = said->text;
      if (machine_->repeats_utterances || words != state.last_utterance) events.push_back(std::move(step));
      state.last_utterance = words;
      for (auto& change : state.beliefs.overhear(words)) events.push_back(std::move(change));
      continue;
    }
    const auto* gestured = std::get_if<Gestured>(&step);
    const auto* acted = std::get_if<Acted>(&step);
    if (!gestured && !acted) {
      events.push_back(std::move(step));
      continue;
    }
    auto command = plan(gestured ? gestured->term : acted->term, gestured != nullptr, perspective_);
    const bool gesture = gestured != nullptr;
    events.push_back(std::move(step));
    if (command) {
      command->id = ++state.commands;
      events.push_back(Commanded{*command, gesture});
    } else {
      events.push_back(Unplanned{command.error().sentence});
    }
  }
}

}  // namespace continua
