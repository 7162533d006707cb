#include "continua/replay/session/session_loop.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/replay/session/expectation.h"

namespace continua {
namespace {

// After the last event the world may go on until it rests, but not longer.
constexpr double longest_tail_s = 120;
// An act may be answered with another one that is done at once, and so on: so often before time goes on.
constexpr int most_rounds = 1000;

}  // namespace

SessionLoop::SessionLoop(const LoadedSession& loaded, std::unique_ptr<Body> body, const Watch& watch, std::ostream& log)
    : loaded_(loaded),
      watch_(watch),
      log_(log),
      episodes_(answers_at_once(loaded.trace)),
      recorder_(log_, *loaded.parts.machine),
      body_(std::move(body)) {
  if (loaded.options.variant != Variant::free)
    following_ = std::make_unique<Following>(loaded.options.variant, answers_at_once(loaded.trace), body_->snapshot(),
                                             *loaded.parts.machine, loaded.parts.language->voxemes.get(),
                                             loaded.parts.perspective);
  use(loaded.parts);
}

void SessionLoop::begin(const std::vector<Note>& notes) {
  log_.write("run", SimTime{}, loaded_.header);
  take(pipeline_->begin(chooser(), body_->snapshot(), loaded_.learned), SimTime{});
  for (const auto& note : notes) recorder_.problem(note.line, note.sentence, SimTime{});
  look_on();
}

void SessionLoop::take(const TraceEvent& event) {
  if (!over_) std::visit([&](const auto& what) { take(event, what); }, event.what);
}

Replayed SessionLoop::finish() {
  settle();
  follow_observed();
  if (!over_) write_end();
  over_ = true;
  return {summary_, state_->learned};
}

void SessionLoop::use(const EngineParts& parts) {
  parts_ = &parts;
  pipeline_ = std::make_unique<Pipeline>(parts.machine, parts.language, parts.perspective, loaded_.most_branches());
}

// Whether the engine is ready for what happens at `t`. From the instant of a what-if on, what is changed counts.
bool SessionLoop::ready(SimTime t) {
  if (!loaded_.what_if || summary_.changed || t < loaded_.what_if->from) return true;
  const EngineParts& was = *parts_;
  use(loaded_.what_if->parts);
  EngineState state = *state_;
  state.chooser.policy = parts_->choice;
  state.chooser.forced = parts_->forced;
  if (parts_->seed != was.seed) state.chooser.random = Random(parts_->seed);
  auto taken_over = pipeline_->take_over(std::move(state), *was.machine, body_->snapshot());
  if (!taken_over) {
    const auto& [machine, sentence] = taken_over.error();
    summary_.stopped = Error{fmt::format("--from {}: {}", loaded_.what_if->from.seconds(), machine), sentence};
    over_ = true;
    return false;
  }
  state_ = std::move(*taken_over);
  recorder_.go_on_with(*parts_->machine);
  for (const auto& note : loaded_.what_if->notes) recorder_.problem(note.line, note.sentence, now_);
  summary_.changed = true;
  return true;
}

void SessionLoop::look_on() {
  if (watch_ && !over_ && watch_(situation())) over_ = true;
}

Situation SessionLoop::situation() const {
  return {pipeline_->machine(), state_->configuration, body_->snapshot(),
          said_since_input_,    recorder_.last_act(),  recorder_.last_referents()};
}

void SessionLoop::take(const TraceEvent& event, const InputEvent& input) {
  if (!ready(now_)) return;
  const bool sample = input.modality == Modality::pointing;
  if (following_ && (following_->at_once() || !sample)) {
    follow_observed();
    following_->begin(*state_, input);
  }
  ++summary_.inputs;
  const int n = recorder_.input(event, symbol_of(input));
  episodes_.begin({now_, n, event.line, symbol_of(input), sample, {}, {}, {}});
  open_ = true;
  take(pipeline_->receive(*state_, input, body_->snapshot()), now_);
  attend();
}

void SessionLoop::take(const TraceEvent& event, const Observed& observed) {
  const int n = recorder_.observed(event, observed);
  episodes_.observed({observed.channel, observed.content, n}, event.t);
}

// Once for each input, when all that was observed of it is known.
void SessionLoop::follow_observed() {
  if (!following_ || !std::exchange(open_, false) || over_) return;
  const auto* episode = following_->at_once() ? episodes_.last() : episodes_.open();
  if (following_->end(*episode, now_)) {
    auto& body = dynamic_cast<KinematicBody&>(*body_);
    WorldReport report{{}, {body.become(following_->world())}, {}, now_};
    if (!report.poses.front().bodies.empty()) recorder_.world(report);
  }
  if (following_->is_corrected()) obey(following_->correct(*pipeline_, *state_, body_->snapshot()), now_);
}

// What is expected is checked once all that happened before has been attended to.
void SessionLoop::take(const TraceEvent& event, const Expectation&) {
  expected_.push_back({event, state_->inputs});
  check_expectations();
}

void SessionLoop::check_expectations() {
  for (; !expected_.empty() && !state_->waits(expected_.front().inputs); expected_.pop_front()) {
    const auto& event = expected_.front().event;
    const auto checked = check(std::get<Expectation>(event.what), situation());
    recorder_.expectation(event, checked.met, checked.found);
    ++summary_.expectations;
    summary_.expectations_met += checked.met;
  }
}

void SessionLoop::take(Tick tick, SimTime t) {
  obey(std::move(tick), t);
  go_on(t);  // what is done at once is done before the next event
}

void SessionLoop::obey(Tick tick, SimTime t) {
  recorder_.engine(tick.events, t);
  for (auto& move : recorder_.take_moves()) episodes_.produced(std::move(move), t);
  for (const auto& event : tick.events) {
    if (const auto* gesture = std::get_if<GestureCommand>(&event)) body_->command(gesture->command);
    if (const auto* act = std::get_if<ActStep>(&event); act && act->command) body_->command(*act->command);
    if (const auto* explored = std::get_if<Explored>(&event)) summary_.pruned += explored->pruned;
    if (const auto* step = std::get_if<StepEvent>(&event))
      if (const auto* said = std::get_if<Said>(step)) said_since_input_.push_back(said->text);
  }
  state_ = std::move(tick.after);
}

void SessionLoop::tell(const std::vector<ActReport>& acts) {
  if (!ready(now_)) return;
  obey(pipeline_->reported(*state_, acts, body_->snapshot()), now_);
  look_on();
}

// Lets the world go on until then. What ends on the way is told to the engine at its time, and what follows from it
// begins at once.
void SessionLoop::go_on(SimTime t) {
  for (int rounds = 0; rounds < most_rounds; ++rounds) {
    const auto report = body_->advance(t);
    recorder_.world(report);
    if (report.until > now_) rounds = 0;
    now_ = report.until;
    const bool ended = std::any_of(report.acts.begin(), report.acts.end(),
                                   [](const ActReport& act) { return act.status != ActReport::Status::started; });
    if (ended) tell(report.acts);
    if (over_) return;
    if (!ended && now_ >= t) return;
  }
}

// Attends to what is complete, one after the other.
void SessionLoop::attend() {
  while (!over_ && !state_->complete.empty()) {
    said_since_input_.clear();
    take(pipeline_->attend(*state_, body_->snapshot()), now_);
    look_on();
    check_expectations();
  }
}

// Time goes on; what has waited long enough on the way is attended to.
void SessionLoop::wait_until(SimTime t) {
  t = std::max(t, now_);
  if (following_ && following_->at_once() && t > now_) follow_observed();
  for (auto due = pipeline_->due(*state_); !over_ && due && *due <= t; due = pipeline_->due(*state_)) {
    go_on(std::max(now_, *due));
    if (over_ || !ready(now_)) return;
    take(pipeline_->wake(*state_, now_), now_);
    attend();
  }
  if (!over_) go_on(t);
}

// Acts that are under way when the trace ends are still finished.
void SessionLoop::settle() {
  for (auto due = pipeline_->due(*state_); !over_ && due; due = pipeline_->due(*state_)) wait_until(*due);
  const SimTime last = now_ + SimTime::from_seconds(longest_tail_s);
  while (!over_ && !body_->at_rest() && now_ < last) go_on(now_ + SimTime::from_seconds(0.1));
}

void SessionLoop::write_end() {
  recorder_.finish();
  const auto& counts = log_.counts();
  summary_.fragile = static_cast<int>(log_.fragile());
  const auto count = [&](const char* kind) { return counts.contains(kind) ? counts.at(kind) : 0; };
  summary_.utterances = count("utterance");
  summary_.refusals = count("refusal");
  summary_.problems = count("problem");
  for (const auto& [number, act] : recorder_.acts()) {
    ++summary_.acts;
    summary_.acts_done += act.status == ActReport::Status::done;
  }
  const bool never = loaded_.what_if && !summary_.changed;
  const EngineParts& forcing = never ? loaded_.what_if->parts : *parts_;
  for (const auto& [step, transition] : never ? forcing.forced : state_->chooser.forced)
    summary_.not_forced[step] = forcing.machine->transitions[transition].id;
  summary_.episodes = episodes_.take(blanks_of(loaded_.scene.initial_snapshot()));
  summary_.end = now_;
  log_.finish(now_);
}

}  // namespace continua
