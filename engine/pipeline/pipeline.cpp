#include "continua/pipeline/pipeline.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "continua/perception/ray_cast.h"
#include "continua/pipeline/account.h"
#include "continua/pipeline/acting.h"
#include "continua/pipeline/behave.h"
#include "continua/pipeline/believe.h"
#include "continua/pipeline/correction.h"
#include "continua/pipeline/fuse.h"
#include "continua/pipeline/hand.h"
#include "continua/pipeline/perceive.h"
#include "continua/pipeline/step.h"
#include "continua/pipeline/taking_over.h"

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
Tick Pipeline::receive(const EngineState& before, const InputEvent& told, const WorldSnapshot& world) const {
  Tick tick{before, {}};
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
  auto fused = fuse(engine_, state, *std::move(percept), now);
  if (!fused) return refuse(fused.error());
  tick.then(follow_hand(engine_, *std::move(fused), event, serial, world));
  return tick;
}

Tick Pipeline::wake(const EngineState& before, SimTime now) const { return {released(engine_, before, now), {}}; }

// Understands. Each move of an utterance is understood in the dialogue that the moves before it have left.
Tick Pipeline::attend(const EngineState& before, const WorldSnapshot& world) const {
  Tick tick{before, {}};
  EngineState& state = tick.after;
  state.words = with_taught(std::move(state.words), state.learned);
  const Ensemble ensemble = take_complete(engine_, state);
  tick.events.push_back(account_of(ensemble, engine_.window));
  const auto offers = offers_of(ensemble, dialogue_of(engine_, state, world));
  Answered answered = answer(std::move(state), offers, world);
  tick.then(std::move(answered.tick));
  if (const auto& sign = offers[answered.taken].sign) state.sign = sign;
  const auto next = [&](const Offer& last) { return next_offer(last, ensemble, dialogue_of(engine_, state, world)); };
  for (auto offer = next(offers[answered.taken]); offer; offer = next(*offer))
    tick.then(answer(std::move(state), {*offer}, world).tick);
  tick.then(act(std::move(state), world));
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

Tick Pipeline::reported(const EngineState& before, const std::vector<ActReport>& reports,
                        const WorldSnapshot& world) const {
  EngineState state = before;
  for (const auto& report : reports) engine_.performer.reported(state.performance, report);
  return act(std::move(state), world);
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
  while (!all.after.complete.empty()) all.then(attend(all.after, world));
  return all;
}

}  // namespace continua
