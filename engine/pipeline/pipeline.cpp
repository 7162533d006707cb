#include "continua/pipeline/pipeline.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/automaton/carry_over.h"
#include "continua/core/located_json.h"
#include "continua/pipeline/discourse.h"
#include "continua/pipeline/inputs.h"
#include "continua/pipeline/lessons.h"

namespace continua {
namespace {

const Catalogue* voxemes_of(const Language* language) { return language ? language->voxemes.get() : nullptr; }
const RaisingRules* raising_of(const Language* language) { return language ? &language->raising : nullptr; }

// Pointings this far beside the table are not believed.
constexpr double beside_m = 0.25;

Box around(const Box& table) {
  const Vec3 margin(beside_m, beside_m, 0);
  return {table.min - margin, table.max + margin};
}

// Where nothing waits, words still go with a pointing that was made before them.
FusionWindow window_of(const Machine& machine) {
  if (!machine.fusion) return {FusionWindow().before_s, 0, 0};
  const auto& [before_s, after_s, lateness_s] = *machine.fusion;
  return {before_s, after_s, lateness_s};
}

// The first that is not what was said last; where there is none, the first.
const std::string& fresh(const std::vector<std::string>& variants, const std::string& last) {
  const auto found = std::find_if(variants.begin(), variants.end(), [&](const auto& one) { return one != last; });
  return found == variants.end() ? variants.front() : *found;
}

}  // namespace

bool EngineState::waits(int serial) const {
  return fusion.waits(serial) || std::any_of(complete.begin(), complete.end(),
                                             [&](const Ensemble& one) { return one.percept.serial <= serial; });
}

Pipeline::Pipeline(std::shared_ptr<const Machine> machine, std::shared_ptr<const Language> language,
                   Perspective perspective, std::size_t most_branches)
    : machine_(std::move(machine)),
      window_(window_of(*machine_)),
      language_(std::move(language)),
      perspective_(perspective),
      performer_(voxemes_of(language_.get()), perspective),
      methods_(perspective, voxemes_of(language_.get())),
      facts_({&term_rules(), &methods_.rules()}, raising_of(language_.get())),
      stepper_(machine_, methods_.rules(), raising_of(language_.get())),
      explorer_(stepper_, most_branches) {
  require(machine_->lexicon.empty() || language_, "a machine with a lexicon needs a language");
}

Tick Pipeline::begin(Chooser chooser, const WorldSnapshot& world, Learned learned) {
  Tick tick{EngineState{{},
                        {},
                        Beliefs(machine_->beliefs),
                        std::move(chooser),
                        Fusion(window_, around(world.table)),
                        {},
                        "",
                        {},
                        std::move(learned),
                        {},
                        0,
                        {},
                        0},
            {}};
  methods_.see(&world, &tick.after.chooser.random, &tick.after.learned);
  open_vocabulary(world);
  begin(tick.after, tick.events);
  perform(tick.after, world, tick.events);
  return tick;
}

void Pipeline::open_vocabulary(const WorldSnapshot& world) {
  if (machine_->lexicon.empty()) return;
  untaught_.emplace(*language_, world, facts_);
  understanding_.emplace(*untaught_);
  taught_.clear();
}

Result<EngineState> Pipeline::take_over(EngineState state, const Machine& was, const WorldSnapshot& world) {
  for (const auto& [name, program] : state.learned.programs)
    if (is_taken(name, *machine_))
      return Error{machine_->name, fmt::format("the run was taught the word {}, which means something else in this "
                                               "machine",
                                               in_quotes(name))};
  auto configuration = carried_over(state.configuration, was, *machine_);
  if (!configuration) return configuration.error();
  state.configuration = std::move(*configuration);
  auto exploration = carried_over(state.exploration, was, *machine_);
  if (!exploration) return exploration.error();
  state.exploration = std::move(*exploration);
  follow_policy(state.chooser, state.configuration, state.exploration);
  state.beliefs = state.beliefs.carried_over(machine_->beliefs);
  state.fusion.use(window_);
  open_vocabulary(world);
  return state;
}

void Pipeline::begin(EngineState& state, std::vector<EngineEvent>& events) {
  if (state.chooser.policy == Choice::explore) return explored(state, explorer_.begin(state.beliefs), events);
  Step step = stepper_.begin(state.beliefs, state.chooser);
  state.configuration = std::move(step.after);
  behave(state, std::move(step.events), events);
}

void Pipeline::step(EngineState& state, std::span<const Input> inputs, std::vector<EngineEvent>& events) {
  if (state.chooser.policy == Choice::explore)
    return explored(state, explorer_.step(state.exploration, inputs, state.beliefs), events);
  Step step = stepper_.step(state.configuration, inputs, state.beliefs, state.chooser);
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

Tick Pipeline::receive(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) {
  Tick tick{before, {}};
  EngineState& state = tick.after;
  const SimTime now = std::max(event.t, world.t);
  keep_up(state.learned);
  const int serial = ++state.inputs;
  tick.events.push_back(Perceived{serial, symbol(event, state.learned)});
  const auto refuse = [&](std::string reason) {
    tick.events.push_back(
        StepEvent(RefusedInput{state.configuration.state, symbol(event, state.learned), std::move(reason), {}}));
  };
  if (!is_confident(event)) {
    refuse(fmt::format("confidence {} is below the machine's minimum of {}", event.confidence,
                       machine_->minimum_confidence));
    return tick;
  }
  if (!state.fusion.receive(percept_of(state, event, serial), now)) {
    refuse(fmt::format("it came {} s late; expected within {} s", (now - event.t).seconds(), state.fusion.latest_s()));
    return tick;
  }
  if (event.modality == Modality::pointing) {
    state.fusion.sample(event, serial, now);
    if (understanding_) follow(state, event, serial, world, tick.events);
  }
  // Where nothing is to be fused, nothing waits.
  if (!machine_->fusion) {
    for (auto& ensemble : state.fusion.release_all()) state.complete.push_back(std::move(ensemble));
    return tick;
  }
  for (auto& ensemble : state.fusion.release(now)) state.complete.push_back(std::move(ensemble));
  return tick;
}

Tick Pipeline::wake(const EngineState& before, SimTime now) {
  Tick tick{before, {}};
  for (auto& ensemble : tick.after.fusion.release(now)) tick.after.complete.push_back(std::move(ensemble));
  return tick;
}

Tick Pipeline::tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) {
  return attended(receive(before, event, world), world);
}

Tick Pipeline::settle(const EngineState& before, const WorldSnapshot& world) {
  Tick tick{before, {}};
  for (auto& ensemble : tick.after.fusion.release_all()) tick.after.complete.push_back(std::move(ensemble));
  return attended(std::move(tick), world);
}

// Attends to all that is complete.
Tick Pipeline::attended(Tick all, const WorldSnapshot& world) {
  while (!all.after.complete.empty()) {
    Tick next = attend(all.after, world);
    all.after = std::move(next.after);
    all.events.insert(all.events.end(), std::make_move_iterator(next.events.begin()),
                      std::make_move_iterator(next.events.end()));
  }
  return all;
}

Tick Pipeline::attend(const EngineState& before, const WorldSnapshot& world) {
  Tick tick{before, {}};
  EngineState& state = tick.after;
  const Ensemble ensemble = std::move(state.complete.front());
  state.complete.pop_front();
  keep_up(state.learned);
  methods_.see(&world, &state.chooser.random, &state.learned);
  tick.events.push_back(Attended{ensemble.percept.serial, ensemble.percept.event.t, ensemble.at, bound(ensemble)});
  if (understanding_ && ensemble.percept.event.modality == Modality::speech)
    hear(state, ensemble, world, tick.events);
  else
    see(state, ensemble, world, tick.events);
  perform(state, world, tick.events);
  return tick;
}

// The words of programs that were taught are words from then on.
void Pipeline::keep_up(const Learned& learned) {
  if (!understanding_ || taught_ == learned.programs) return;
  taught_ = learned.programs;
  understanding_.emplace(*untaught_);
  for (const auto& [name, program] : taught_) understanding_->learn(name, program.type());
}

bool Pipeline::is_confident(const InputEvent& event) const {
  const auto enough = [&](double confidence) { return confidence >= machine_->minimum_confidence; };
  return enough(event.confidence) || std::any_of(event.alternatives.begin(), event.alternatives.end(),
                                                 [&](const Alternative& one) { return enough(one.confidence); });
}

// Gestures that were taught are moves that say an action.
std::string Pipeline::symbol(const InputEvent& event, const Learned& learned) const {
  if (event.modality != Modality::gesture || !language_ || !language_->gestures) return symbol_of(event);
  if (learned.gestures.contains(event.name) && event.phase != "stop") return text(Modality::gesture) + " " + iconic;
  return gesture_symbol(event, language_->gestures->find(event.name));
}

std::string Pipeline::kind_of(const InputEvent& event, const Learned& learned) const {
  const auto name = symbol(event, learned);
  const auto found = std::find_if(machine_->moves.begin(), machine_->moves.end(),
                                  [&](const MoveKind& kind) { return kind.inputs.contains(name); });
  if (found != machine_->moves.end()) return found->name;
  if (event.modality != Modality::gesture || !language_ || !language_->gestures) return {};
  if (learned.gestures.contains(event.name) && event.phase != "stop") return iconic;
  const auto* entry = language_->gestures->find(event.name);
  return entry && entry->acts(event.phase) ? entry->kind : std::string();
}

Percept Pipeline::percept_of(const EngineState& state, const InputEvent& event, int serial) const {
  Percept percept{serial, event, {}, {}};
  if (event.modality == Modality::speech && understanding_) {
    percept.takers = takers(understanding_->read(event.text), event);
  } else if (event.modality == Modality::gesture && kind_of(event, state.learned) == deixis) {
    // A gesture that does not say where it points points where the hand does.
    if (!place_of(event) && state.pointed && (event.t - state.pointed->t).seconds() <= window_.before_s)
      percept.event.target_W = state.pointed->place_W;
    percept.deixis = deixis_of(percept.event, serial);
  }
  return percept;
}

Discourse Pipeline::discourse_now(const EngineState& state, const Input& input, const WorldSnapshot& world) {
  return discourse_of(stepper_, state.configuration, input, state.beliefs, world);
}

// Offers one or several inputs of which one counts; returns which the automaton took.
std::size_t Pipeline::offer(EngineState& state, std::span<const Input> inputs, std::vector<EngineEvent>& events) {
  update_beliefs(state, inputs.front(), events);
  std::vector<Input> offered;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (machine_->ignored.contains(inputs[i].symbol) || inputs[i].confidence < machine_->minimum_confidence) continue;
    offered.push_back(inputs[i]);
    which.push_back(i);
  }
  if (offered.empty()) return 0;
  const auto first = events.size();
  step(state, offered, events);
  for (auto event = events.begin() + static_cast<std::ptrdiff_t>(first); event != events.end(); ++event)
    if (const auto* step = std::get_if<StepEvent>(&*event))
      if (const auto* fired = std::get_if<Fired>(step); fired && fired->input) return which[fired->alternative];
  return which.front();
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
  for (auto& step : with_lessons(std::move(steps), *machine_, state.learned)) {
    if (const auto* taught = std::get_if<Taught>(&step)) state.lessons[taught->name] = taught->because;
    if (auto* said = std::get_if<Said>(&step)) {
      const std::string words = said->text = fresh(said->variants, state.last_utterance);
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
