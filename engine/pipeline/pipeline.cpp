#include "continua/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "continua/perception/ray_cast.h"
#include "continua/pipeline/account.h"
#include "continua/pipeline/acting.h"
#include "continua/pipeline/behave.h"
#include "continua/pipeline/believe.h"
#include "continua/pipeline/correction.h"
#include "continua/pipeline/doubt.h"
#include "continua/pipeline/following.h"
#include "continua/pipeline/fuse.h"
#include "continua/pipeline/instant.h"
#include "continua/pipeline/perceive.h"
#include "continua/pipeline/step.h"
#include "continua/pipeline/taking_over.h"
#include "continua/pipeline/together.h"

namespace continua {
namespace {

// The machine may answer the end of an act with another act. The bound stops acts that answer each other without time
// passing.
constexpr int most_news = 100;

}  // namespace

Tick Pipeline::begin(Chooser chooser, const WorldSnapshot& world, Learned learned) const {
  EngineState state(Beliefs(engine_.machine->beliefs), std::move(chooser), first_fusion(engine_, world));
  state.learned = std::move(learned);
  state.words = first_words(engine_, world);
  Tick tick = behave(engine_, first_step(engine_, std::move(state), world));
  tick.then(act(std::move(tick.after), world));
  return tick;
}

// Perceives and fuses.
Tick Pipeline::receive(EngineState before, const InputEvent& told, const WorldSnapshot& world) const {
  Tick tick{std::move(before), {}};
  EngineState& state = tick.after;
  const InputEvent event = with_name(engine_, state, with_target(told, world));
  const SimTime now = std::max(event.t, world.t);
  const int serial = ++state.inputs;
  state.words = with_taught(std::move(state.words), state.learned);
  const auto symbol = symbol_of(engine_, state, event);
  tick.events.push_back(Perceived{serial, symbol});
  const auto refuse = [&](const Error& why) {
    tick.events.push_back(StepEvent(RefusedInput{state.configuration.state, symbol, why.sentence, {}}));
    return tick;
  };
  auto percept = perceive(engine_, state, event, serial);
  if (!percept) return refuse(percept.error());
  if (!event.final) {
    tick.then(overhear(std::move(state), *std::move(percept), now, world));
    return tick;
  }
  if (event.modality == Modality::gaze) {
    tick.then(follow_eyes(engine_, std::move(state), event, serial, world));
    return tick;
  }
  auto fused = fuse(engine_, state, *std::move(percept), now);
  if (!fused) return refuse(fused.error());
  tick.then(follow_hand(engine_, *std::move(fused), event, serial, world));
  return tick;
}

bool Pipeline::comes_before(const EngineState& state, const InputEvent& a, const InputEvent& b) const {
  return machine().fusion && continua::comes_before(engine_, state, a, b);
}

Tick Pipeline::wake(EngineState before, SimTime now) const {
  Tick tick{released(engine_, std::move(before), now), {}};
  EngineState& state = tick.after;
  if (!state.hold || now < state.hold->until || !state.complete.empty()) return tick;
  // An input that came meanwhile may still call the act off; one that comes from now on may not.
  const int inputs = state.hold->inputs.value_or(state.inputs);
  const auto due = state.fusion.waits(inputs) ? state.fusion.due() : std::nullopt;
  if (due)
    state.hold = {*due, inputs};
  else
    state.hold.reset();
  return tick;
}

std::optional<SimTime> Pipeline::due(const EngineState& state) const {
  const auto due = state.fusion.due();
  if (!state.hold) return due;
  return std::min(due.value_or(state.hold->until), state.hold->until);
}

// Understands. Each move of an utterance is understood in the dialogue that the moves before it have left.
Tick Pipeline::attend(EngineState before, const WorldSnapshot& world) const {
  if (auto both = attended_together(engine_, before, world)) {
    both->then(act(std::move(both->after), world));
    return *std::move(both);
  }
  Tick tick{std::move(before), {}};
  EngineState& state = tick.after;
  state.words = with_taught(std::move(state.words), state.learned);
  const Ensemble ensemble = take_complete(engine_, state);
  tick.events.push_back(account_of(ensemble, engine_.window));
  hold(state, ensemble.percept.event, world.t);
  state.looked = looked_at(engine_, state, ensemble.at);
  state.doubted.insert_or_assign(0, ensemble);
  const auto offers = offers_of(ensemble, dialogue_of(engine_, state, world));
  std::optional<EngineState> unanswered;
  if (may_ask(ensemble, offers)) unanswered = state;
  Answered answered = answer(std::move(state), offers, world);
  if (auto asked = unanswered ? ask(*unanswered, ensemble, offers, answered, world) : std::nullopt) {
    tick.then(*std::move(asked));
    tick.then(act(std::move(state), world));
    return tick;
  }
  tick.then(std::move(answered.tick));
  if (const auto& sign = offers[answered.taken].sign) state.sign = sign;
  const auto next = [&](const Offer& last) { return next_offer(last, ensemble, dialogue_of(engine_, state, world)); };
  for (std::optional<Offer> offer = offers[answered.taken]; offer && !comes_again(state, *offer);) {
    offer = next(*offer);
    if (offer) tick.then(answer(std::move(state), {*offer}, world).tick);
  }
  tick.then(act(std::move(state), world));
  return tick;
}

// An act that words ask for changes nothing while a gesture may still be shown with them.
void Pipeline::hold(EngineState& state, const InputEvent& event, SimTime now) const {
  if (event.modality != Modality::speech || engine_.window.together_s == 0) return;
  const SimTime until = event.until.value_or(event.t) + SimTime::from_seconds(engine_.window.together_s);
  if (until > now && (!state.hold || state.hold->until < until)) state.hold = {until};
}

// The offers to ask about: the one taken, if it is unsure, and those that are about as likely and lead elsewhere. One
// that means nothing to the lexicon is no rival.
std::vector<std::size_t> Pipeline::doubted(const EngineState& state, const std::vector<Offer>& offers,
                                           const Answered& answered, const WorldSnapshot& world) const {
  const auto& taken = offers[answered.taken].input;
  const auto* thresholds = machine().thresholds_of(taken.symbol);
  std::vector<std::size_t> doubted{answered.taken};
  std::vector<Tick> outcomes{answered.tick};
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const bool means_nothing = !machine().lexicon.empty() && offers[i].move.kind.empty();
    const double less = std::abs(offers[i].input.confidence - taken.confidence);
    if (i == answered.taken || means_nothing || !(less < machine().near_tie)) continue;
    Offer alone = offers[i];
    alone.input.confidence = taken.confidence;
    Tick outcome = answer(state, {alone}, world).tick;
    const auto differs = [&](const Tick& other) { return lead_elsewhere(outcome, other); };
    if (is_refused(outcome) || !std::all_of(outcomes.begin(), outcomes.end(), differs)) continue;
    doubted.push_back(i);
    outcomes.push_back(std::move(outcome));
  }
  if (doubted.size() == 1 && !(thresholds && taken.confidence < thresholds->confirm)) doubted.clear();
  return doubted;
}

// Whether the machine may ask about one of the offers: it is unsure, or not the only one. A move that is attended to
// again was asked about with those before it.
bool Pipeline::may_ask(const Ensemble& ensemble, const std::vector<Offer>& offers) const {
  const auto& percept = ensemble.percept;
  const bool is_later_move = percept.resumes && percept.resumes->fragment > 0;
  if (!percept.assured.empty() || is_later_move) return false;
  const auto* thresholds = machine().thresholds_of(offers.front().input.symbol);
  const bool unsure = thresholds && offers.front().input.confidence < thresholds->confirm;
  return (offers.size() > 1 || unsure) && machine().knows_input(unsure_symbol);
}

// Asks about an input that is unsure; nothing if it is sure, or if the machine does not ask.
std::optional<Tick> Pipeline::ask(const EngineState& state, const Ensemble& ensemble, const std::vector<Offer>& offers,
                                  const Answered& answered, const WorldSnapshot& world) const {
  if (is_refused(answered.tick) || machine().ignored.contains(offers[answered.taken].input.symbol)) return std::nullopt;
  const auto doubts = doubted(state, offers, answered, world);
  if (doubts.empty()) return std::nullopt;
  auto doubt = doubt_of(state, ensemble, offers, doubts);
  Tick tick{doubt.state, account_of(offers, answered.taken)};
  auto stepped = step_if_taken(engine_, std::move(doubt.state), doubt.input, world);
  if (!stepped) return std::nullopt;
  tick.then(behave(engine_, *std::move(stepped)));
  return tick;
}

// Words that are not final may make the avatar look up. They change nothing else.
Tick Pipeline::overhear(EngineState state, Percept percept, SimTime now, const WorldSnapshot& world) const {
  Ensemble ensemble{std::move(percept), {}, now};
  ensemble.bound.resize(ensemble.percept.takers.size());
  state.looked = looked_at(engine_, state, now);
  auto offers = offers_of(ensemble, dialogue_of(engine_, state, world));
  offers.resize(1);
  Input& input = offers.front().input;
  input.symbol = interim_symbol;
  Tick tick{std::move(state), account_of(offers, 0)};
  if (auto stepped = step_if_taken(engine_, tick.after, input, world)) tick.then(behave(engine_, *std::move(stepped)));
  return tick;
}

Pipeline::Answered Pipeline::answer(EngineState state, const std::vector<Offer>& offers,
                                    const WorldSnapshot& world) const {
  std::vector<Input> inputs;
  for (const auto& offer : offers) inputs.push_back(offer.input);
  Answered answered = answer(std::move(state), inputs, world);
  auto& events = answered.tick.events;
  const auto account = account_of(offers, answered.taken);
  events.insert(events.begin(), account.begin(), account.end());
  return answered;
}

// Believes, steps and behaves.
Pipeline::Answered Pipeline::answer(EngineState state, std::span<const Input> inputs,
                                    const WorldSnapshot& world) const {
  Tick tick = believe(engine_, std::move(state), inputs.front(), world);
  Stepped stepped = step(engine_, std::move(tick.after), inputs, world);
  const auto taken = stepped.taken;
  tick.then(behave(engine_, std::move(stepped)));
  return {std::move(tick), taken};
}

// Acts until the body has to report. The beginning and the end of an act may be inputs.
Tick Pipeline::act(EngineState state, const WorldSnapshot& world) const {
  Tick tick{std::move(state), {}};
  for (int inputs = 1;; ++inputs) {
    auto [performed, news] = perform(engine_, std::move(tick.after), world);
    tick.then(std::move(performed));
    if (!news) return tick;
    if (inputs > most_news) {
      tick.events.push_back(StepEvent(Trouble{fmt::format("more than {} acts begin or end at once", most_news)}));
      return tick;
    }
    const Input input = to_input(*news, ++tick.after.inputs, world.t);
    tick.events.push_back(Perceived{input.serial, input.symbol, news->act.number});
    tick.then(answer(std::move(tick.after), {&input, 1}, world).tick);
  }
}

Result<EngineState> Pipeline::take_over(EngineState state, const Machine& was, const WorldSnapshot& world) const {
  return taken_over(engine_, std::move(state), was, world);
}

Tick Pipeline::reported(EngineState before, const std::vector<ActReport>& reports, const WorldSnapshot& world) const {
  for (const auto& report : reports) engine_.performer.reported(before.performance, report);
  return act(std::move(before), world);
}

Tick Pipeline::corrected(const EngineState& before, const EngineState& after, const InputEvent& event,
                         const ObservedMoves& observed, const WorldSnapshot& world) const {
  return correct(engine_, before, after, event, observed, world);
}

Tick Pipeline::tick(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) const {
  return attend_all(receive(before, event, world), world);
}

Tick Pipeline::settle(const EngineState& before, const WorldSnapshot& world) const {
  return attend_all({released_all(engine_, before), {}}, world);
}

Tick Pipeline::attend_all(Tick all, const WorldSnapshot& world) const {
  while (!all.after.complete.empty()) all.then(attend(std::move(all.after), world));
  return all;
}

}  // namespace continua
