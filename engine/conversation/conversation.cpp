#include "continua/conversation/conversation.h"

#include <algorithm>
#include <utility>

namespace continua {
namespace {

// The engine may answer the end of an act with another act that ends at once, and so on. The bound on such rounds lets
// time go on.
constexpr int most_rounds = 1000;

}  // namespace

Conversation::Conversation(EngineParts parts, Body& body, std::size_t most_branches)
    : parts_(std::move(parts)),
      body_(body),
      most_branches_(most_branches),
      pipeline_(parts_.machine, parts_.language, parts_.perspective, most_branches) {}

std::vector<Happening> Conversation::begin(Learned learned) { return all({}, {open(std::move(learned))}); }

std::vector<Happening> Conversation::hear(const InputEvent& event) { return all({}, {receive(event)}); }

std::vector<Happening> Conversation::advance(SimTime t) { return all(t, {}); }

std::vector<Happening> Conversation::all(std::optional<SimTime> t, std::vector<Happening> happenings) {
  run(t, {[](Step) { return true; },
          [&](Step, Happening happening) {
            happenings.push_back(std::move(happening));
            return true;
          }});
  return happenings;
}

void Conversation::run(std::optional<SimTime> t, const Onlooker& onlooker) {
  for (int rounds = 0;;) {
    const auto step = next(t);
    if (step == Step::none || !onlooker.before(step)) return;
    const auto was = now_;
    if (!onlooker.after(step, take(step, t))) return;
    if (now_ > was) rounds = 0;
    if (step != Step::world || ++rounds < most_rounds) continue;
    if (settled_) return;
    settled_ = true;
    rounds = 0;
  }
}

Thought Conversation::open(Learned learned) {
  return obey(pipeline_.begin(parts_.chooser(), body_.snapshot(), std::move(learned)));
}

Thought Conversation::receive(const InputEvent& event) {
  return obey(pipeline_.receive(*std::move(state_), event, body_.snapshot()));
}

Thought Conversation::change(const Change& change) {
  const bool settled = settled_;
  auto thought = obey(change(pipeline_, *state_, body_.snapshot()));
  settled_ = settled;
  return thought;
}

Outcome Conversation::go_on_with(EngineParts parts, const std::function<void(EngineState&)>& prepare) {
  Pipeline pipeline(parts.machine, parts.language, parts.perspective, most_branches_);
  EngineState state = *state_;
  prepare(state);
  auto taken_over = pipeline.take_over(std::move(state), *parts_.machine, body_.snapshot());
  if (!taken_over) return taken_over.error();
  state_ = *std::move(taken_over);
  pipeline_ = std::move(pipeline);
  parts_ = std::move(parts);
  return std::nullopt;
}

Conversation::Step Conversation::next(std::optional<SimTime> t) const {
  if (!untold_.empty()) return Step::tell;
  // A call-off that is complete at the instant at which an act begins still stops the act.
  const bool can_attend = !state_->complete.empty();
  if (!settled_ && !(only_begun_ && can_attend)) return Step::world;
  if (can_attend) return Step::attend;
  if (!t) return Step::none;
  const auto due = this->due();
  if (due && *due <= now_) return Step::wake;
  return now_ < *t ? Step::world : Step::none;
}

Happening Conversation::take(Step step, std::optional<SimTime> t) {
  if (step == Step::tell)
    return obey(pipeline_.reported(*std::move(state_), std::exchange(untold_, {}), body_.snapshot()));
  if (step == Step::attend) {
    only_begun_ = false;
    return obey(pipeline_.attend(*std::move(state_), body_.snapshot()));
  }
  if (step == Step::wake) return obey(pipeline_.wake(*std::move(state_), now_));
  if (!settled_) return let_world_go_on(now_);
  return let_world_go_on(std::min(*t, due().value_or(*t)));
}

// Takes the engine's next state. Commands reach the body in the order in which the engine gave them.
Thought Conversation::obey(Tick tick) {
  for (const auto& event : tick.events) {
    if (const auto* gesture = std::get_if<GestureCommand>(&event)) body_.command(gesture->command);
    if (const auto* act = std::get_if<ActStep>(&event); act && act->command) body_.command(*act->command);
  }
  state_ = std::move(tick.after);
  body_.hold(state_->hold.has_value());
  settled_ = false;
  return {now_, std::move(tick.events)};
}

// Advances the world to `t`, or to the beginning or end of an act, so that its consequences begin at once.
WorldReport Conversation::let_world_go_on(SimTime t) {
  auto report = body_.advance(t);
  untold_ = report.acts;
  const auto is_begin = [](const ActReport& act) { return act.status == ActReport::Status::started; };
  only_begun_ = !untold_.empty() && std::all_of(untold_.begin(), untold_.end(), is_begin);
  now_ = report.until;
  settled_ = settled_ || untold_.empty();
  return report;
}

}  // namespace continua
