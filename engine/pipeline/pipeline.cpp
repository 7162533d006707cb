#include "pipeline/pipeline.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/discourse.h"
#include "pipeline/inputs.h"

namespace continua {
namespace {

const RaisingRules* raising_of(const Language* language) { return language ? &language->raising : nullptr; }

bool is_recent(const Pointed& pointed, SimTime now) { return (now - pointed.t).seconds() <= pointing_lasts_s; }

std::string kind_of(const Input& input, const Machine& machine) {
  const auto found = std::find_if(machine.moves.begin(), machine.moves.end(),
                                  [&](const MoveKind& kind) { return kind.inputs.contains(input.symbol); });
  return found == machine.moves.end() ? std::string() : found->name;
}

}  // namespace

Pipeline::Pipeline(std::shared_ptr<const Machine> machine, std::shared_ptr<const Language> language,
                   std::shared_ptr<const Catalogue> catalogue, Perspective perspective, std::size_t most_branches)
    : machine_(std::move(machine)),
      language_(std::move(language)),
      catalogue_(catalogue ? std::move(catalogue) : std::make_shared<const Catalogue>()),
      perspective_(perspective),
      performer_(*catalogue_, perspective),
      methods_(perspective),
      facts_({&term_rules(), &methods_.rules()}, raising_of(language_.get())),
      stepper_(machine_, methods_.rules(), raising_of(language_.get())),
      explorer_(stepper_, most_branches) {
  require(machine_->lexicon.empty() || language_, "a machine with a lexicon needs a language");
}

Tick Pipeline::begin(Chooser chooser, const WorldSnapshot& world) {
  Tick tick{EngineState{{}, {}, Beliefs(machine_->beliefs), std::move(chooser), "", {}, 0, {}, 0}, {}};
  methods_.see(&world, &tick.after.chooser.random);
  if (!machine_->lexicon.empty()) understanding_.emplace(*language_, world, facts_);
  begin(tick.after, tick.events);
  perform(tick.after, world, tick.events);
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

  Input input = to_input(event, ++state.inputs);
  tick.events.push_back(Perceived{input.serial, input.symbol});
  if (input.confidence < machine_->minimum_confidence) {
    tick.events.push_back(StepEvent(RefusedInput{state.configuration.state,
                                                 input.symbol,
                                                 fmt::format("confidence {} is below the machine's minimum of {}",
                                                             input.confidence, machine_->minimum_confidence),
                                                 {}}));
    return tick;
  }
  if (understanding_ && event.modality == Modality::speech) {
    hear(state, event, std::move(input), world, tick.events);
  } else {
    see(state, event, input, world, tick.events);
    offer(state, input, tick.events);
  }
  perform(state, world, tick.events);
  return tick;
}

// Each move of an utterance is understood in what the ones before it have left.
void Pipeline::hear(EngineState& state, const InputEvent& event, Input input, const WorldSnapshot& world,
                    std::vector<EngineEvent>& events) {
  const auto utterance = understanding_->read(event.text);
  if (utterance.fragments.empty()) {
    events.push_back(Understood{understanding_->not_understood(utterance), {input.serial}});
    return offer(state, input, events);
  }
  for (std::size_t fragment = 0; fragment < utterance.fragments.size(); ++fragment) {
    const auto discourse = discourse_now(state, input, world);
    auto move = understanding_->understood(utterance, fragment, discourse.context);
    carry(move, input);
    events.push_back(Understood{move, sources(move, input.serial, discourse)});
    for (const auto& applying : move.interpretation.applied)
      events.push_back(StepEvent(Applied{applying.application, sources(applying, input.serial, discourse)}));
    offer(state, input, events);
  }
}

// Gestures and pointing. That the human points at something else than before is a move too.
void Pipeline::see(EngineState& state, const InputEvent& event, Input& input, const WorldSnapshot& world,
                   std::vector<EngineEvent>& events) {
  Move move;
  move.kind = kind_of(input, *machine_);
  if (!understanding_) {
    if (!move.kind.empty()) events.push_back(Understood{std::move(move), {input.serial}});
    return;
  }
  const auto before = state.pointed;
  if (const auto place_W = place_of(event)) state.pointed = Pointed{*place_W, event.t, input.serial, ""};
  const auto discourse = discourse_now(state, input, world);
  if (discourse.context.pointed_W) {
    const auto pointed = refer_to_pointed(discourse.context);
    if (!pointed.referents.empty()) state.pointed->object = pointed.referents.front().object;
    const bool elsewhere = !before || before->object != state.pointed->object || !is_recent(*before, event.t);
    if (event.modality == Modality::pointing && elsewhere) move.kind = deixis;
    if (move.kind == deixis) move.reference = pointed;
  }
  carry(move, input);
  if (!move.kind.empty()) events.push_back(Understood{move, sources(move, input.serial, discourse)});
}

Discourse Pipeline::discourse_now(const EngineState& state, Input& input, const WorldSnapshot& world) {
  auto discourse = discourse_of(stepper_, state.configuration, input, state.beliefs, world);
  if (state.pointed && is_recent(*state.pointed, SimTime::from_seconds(input.now_s))) {
    discourse.context.pointed_W = state.pointed->place_W;
    discourse.pointed = {state.pointed->serial};
    input.pointed = point_term(state.pointed->place_W);
  }
  return discourse;
}

void Pipeline::offer(EngineState& state, const Input& input, std::vector<EngineEvent>& events) {
  update_beliefs(state, input, events);
  if (!machine_->ignored.contains(input.symbol)) step(state, input, events);
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
    if (const auto* gestured = std::get_if<Gestured>(&step)) {
      const Term term = gestured->term;
      events.push_back(std::move(step));
      gesture(state, term, events);
      continue;
    }
    if (const auto* acted = std::get_if<Acted>(&step))
      performer_.begin(state.performance, {++state.acts, acted->term, acted->because});
    events.push_back(std::move(step));
  }
}

}  // namespace continua
