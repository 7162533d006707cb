#include "continua/replay/session/session_loop.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "continua/replay/session/expectation.h"

namespace continua {
namespace {

// After the last event the world may go on until it rests, but not longer.
constexpr double longest_tail_s = 120;
constexpr SimTime longest_unasked{250'000};  // while the world moves
constexpr std::size_t most_unmet = 10;       // expectations that a summary tells of

// The fields of an `expect` line, in its order.
Json expected_of(const TraceEvent& event) {
  Json expected = event.json;
  expected.erase("t");
  expected.erase("kind");
  return expected;
}

}  // namespace

SessionLoop::SessionLoop(const LoadedSession& loaded, std::unique_ptr<Body> body, const Watch& watch, std::ostream& log)
    : loaded_(loaded),
      watch_(watch),
      log_(log),
      episodes_(loaded.trace.answers_at_once(), loaded.options.episodes),
      recorder_(log_, *loaded.parts.machine),
      body_(std::move(body)),
      conversation_(loaded.parts, *body_, loaded.most_branches()) {
  if (loaded.options.variant != Variant::free)
    following_ = std::make_unique<Following>(loaded.options.variant, loaded.trace.answers_at_once(), body_->snapshot(),
                                             *loaded.parts.machine, loaded.parts.language->voxemes.get(),
                                             loaded.parts.perspective);
}

const std::string& SessionLoop::state() const {
  return conversation_.pipeline().machine().states[conversation_.state().configuration.state].name;
}

void SessionLoop::begin(const std::vector<Note>& notes) {
  if (loaded_.parts.outside) loaded_.parts.outside->begin();
  if (loaded_.what_if && loaded_.what_if->parts.outside) loaded_.what_if->parts.outside->begin();
  log_.write(loaded_.header, SimTime{});
  record(conversation_.open(loaded_.learned));
  run({});
  for (const auto& note : notes) recorder_.problem(note.line, note.sentence, SimTime{});
  look_on();
}

template <class What>
void SessionLoop::take(const TraceEvent& event, const What& what) {
  if constexpr (requires { record_of(event, what); }) recorder_.trace_event(event, record_of(event, what));
}

void SessionLoop::take(const TraceEvent& event) {
  if (!over_) std::visit([&](const auto& what) { take(event, what); }, event.what);
}

std::vector<const TraceEvent*> SessionLoop::in_order(std::span<const TraceEvent> events) const {
  std::vector<const TraceEvent*> ordered;
  for (const auto& event : events) ordered.push_back(&event);
  // Another avatar's answers belong to the inputs as its recorder told them.
  if (following_) return ordered;
  const auto input_of = [](const TraceEvent* event) { return std::get_if<InputEvent>(&event->what); };
  for (auto begin = ordered.begin(); begin != ordered.end();) {
    const auto end = std::find_if_not(begin, ordered.end(), input_of);
    std::stable_sort(begin, end, [&](const TraceEvent* a, const TraceEvent* b) {
      return conversation_.pipeline().comes_before(conversation_.state(), *input_of(a), *input_of(b));
    });
    begin = end == ordered.end() ? end : std::next(end);
  }
  return ordered;
}

Replayed SessionLoop::finish() {
  settle();
  follow_observed();
  if (!over_) write_end();
  over_ = true;
  return {summary_, conversation_.state().learned};
}

// Whether the engine is ready for the present instant. From the instant of a what-if on, its parts count.
bool SessionLoop::ready() {
  if (!loaded_.what_if || summary_.changed || now() < loaded_.what_if->from) return true;
  const auto& parts = loaded_.what_if->parts;
  const bool other_seed = parts.seed != conversation_.parts().seed;
  const auto problem = conversation_.go_on_with(parts, [&](EngineState& state) {
    state.chooser.policy = parts.choice;
    state.chooser.outside = parts.outside;
    state.chooser.forced = parts.forced;
    if (other_seed) state.chooser.random = Random(parts.seed);
  });
  if (problem) {
    stop({fmt::format("--from {}: {}", loaded_.what_if->from.seconds(), problem->where), problem->sentence});
    return false;
  }
  recorder_.go_on_with(*conversation_.parts().machine);
  for (const auto& note : loaded_.what_if->notes) recorder_.problem(note.line, note.sentence, now());
  summary_.changed = true;
  return true;
}

void SessionLoop::stop(const Error& reason) {
  summary_.stopped = reason;
  over_ = true;
}

void SessionLoop::look_on() {
  if (watch_ && !over_ && watch_(situation())) over_ = true;
}

Situation SessionLoop::situation() const {
  return {conversation_.pipeline().machine(),
          conversation_.state().configuration,
          body_->snapshot(),
          said_since_input_,
          recorder_.acts().empty() ? std::string() : recorder_.acts().rbegin()->second.program,
          recorder_.last_referents()};
}

void SessionLoop::take(const TraceEvent& event, const InputEvent& input) {
  if (!ready()) return;
  const bool sample = input.modality == Modality::pointing || input.modality == Modality::gaze;
  if (following_ && (following_->at_once() || !sample)) {
    follow_observed();
    following_->begin(conversation_.state(), input);
  }
  if (loaded_.options.before_input) prepare(event, input);
  ++summary_.inputs;
  const int n = recorder_.input(event, symbol_of(input));
  episodes_.begin({now(), n, event.line, symbol_of(input), sample, {}, {}, {}});
  open_ = true;
  record(conversation_.receive(input));
  run({});
}

void SessionLoop::prepare(const TraceEvent& event, const InputEvent& input) {
  record(conversation_.change([&](const Pipeline& pipeline, const EngineState& state, const WorldSnapshot& world) {
    Tick tick{state, {}};
    tick.after.chooser.forced = loaded_.options.before_input(pipeline, state, input, world, event.line);
    return tick;
  }));
}

void SessionLoop::take(const TraceEvent& event, const Observed& observed) {
  const int n = recorder_.trace_event(event, record_of(event, observed));
  episodes_.observed({observed.channel, observed.content, n}, event.t);
}

// Once for each input, when all that was observed of it is known.
void SessionLoop::follow_observed() {
  if (!following_ || !std::exchange(open_, false) || over_) return;
  const auto* episode = following_->at_once() ? episodes_.last() : episodes_.open();
  if (following_->end(*episode, now())) {
    auto& body = dynamic_cast<KinematicBody&>(*body_);
    WorldReport report{{}, {body.become(following_->world())}, {}, now()};
    if (!report.poses.front().bodies.empty()) recorder_.world(report);
  }
  if (!following_->is_corrected()) return;
  record(conversation_.change([&](const Pipeline& pipeline, const EngineState& state, const WorldSnapshot& world) {
    return following_->correct(pipeline, state, world);
  }));
}

// An expectation is checked once everything before it has been attended to.
void SessionLoop::take(const TraceEvent& event, const Expectation&) {
  expected_.push_back({event, conversation_.state().inputs});
  check_expectations();
}

void SessionLoop::check_expectations() {
  for (; !expected_.empty() && !conversation_.state().waits(expected_.front().inputs); expected_.pop_front()) {
    const auto& event = expected_.front().event;
    const auto checked = check(std::get<Expectation>(event.what), situation());
    auto expected = expected_of(event);
    ++summary_.expectations;
    summary_.expectations_met += checked.met;
    if (!checked.met && summary_.unmet.size() < most_unmet)
      summary_.unmet.push_back({event.line, event.t, compact(expected), compact(checked.found)});
    recorder_.expectation({static_cast<std::int64_t>(event.line), checked.met, std::move(expected), checked.found},
                          event.t);
  }
}

// A policy from outside may be unable to go on. The run ends there.
void SessionLoop::heed_outside() {
  const auto& outside = conversation_.state().chooser.outside;
  if (const auto trouble = outside ? outside->trouble() : std::nullopt; trouble && !over_) stop(*trouble);
}

void SessionLoop::record(const Thought& thought) {
  heed_outside();
  recorder_.engine(thought.events, thought.t);
  for (auto& move : recorder_.take_moves()) episodes_.produced(std::move(move), thought.t);
  for (const auto& event : thought.events) {
    if (const auto* explored = std::get_if<Explored>(&event)) summary_.pruned += explored->pruned;
    if (const auto* step = std::get_if<StepEvent>(&event))
      if (const auto* said = std::get_if<Said>(step)) said_since_input_.push_back(said->text);
  }
}

// The conversation goes on, to the log. Expectations are checked when an input has been attended to, with all that
// followed from it at once, or up to the next input of the same instant.
void SessionLoop::run(std::optional<SimTime> t) {
  if (over_) return;
  bool attending = false;
  const auto attended = [&] {
    attending = false;
    look_on();
    check_expectations();
  };
  const auto before = [&](Step step) {
    if (step == Step::attend) {
      if (attending) attended();
      said_since_input_.clear();
    }
    return step == Step::world || ready();
  };
  const auto after = [&](Step step, const Happening& happening) {
    std::visit([&](const auto& what) { record(what); }, happening);
    if (step == Step::tell) look_on();
    attending = attending || step == Step::attend;
    if (!over_ && attending && conversation_.is_settled()) attended();
    return !over_;
  };
  conversation_.run(t, {before, after});
}

void SessionLoop::wait_until(SimTime t) {
  t = std::max(t, now());
  if (following_ && following_->at_once() && t > now()) follow_observed();
  if (loaded_.options.give_up) look_around_until(t);
  run(t);
}

void SessionLoop::give_up_if_asked() {
  if (const auto& give_up = loaded_.options.give_up; give_up && give_up()) over_ = true;
}

// The world goes on in short pieces, which makes no difference to it.
void SessionLoop::look_around_until(SimTime t) {
  while (!over_) {
    give_up_if_asked();
    const auto next = body_->at_rest() ? conversation_.due().value_or(t) : now() + longest_unasked;
    if (over_ || next >= t) return;
    run(std::max(next, now() + SimTime{1}));
  }
}

// Acts that are under way when the trace ends are still finished.
void SessionLoop::settle() {
  for (auto due = conversation_.due(); !over_ && due; due = conversation_.due()) wait_until(*due);
  const SimTime last = now() + SimTime::from_seconds(longest_tail_s);
  while (!over_ && !body_->at_rest() && now() < last) {
    run(now() + SimTime::from_seconds(0.1));
    give_up_if_asked();
  }
}

void SessionLoop::write_end() {
  recorder_.finish();
  summary_.fragile = static_cast<int>(log_.fragile());
  const auto count = [&](const log::Kind& kind) {
    const auto found = log_.counts().find(kind.name);
    return found == log_.counts().end() ? 0 : static_cast<int>(found->second);
  };
  summary_.utterances = count(log::Utterance::kind);
  summary_.refusals = count(log::Refusal::kind);
  summary_.problems = count(log::Problem::kind);
  for (const auto& [number, act] : recorder_.acts()) {
    ++summary_.acts;
    summary_.acts_done += act.status == ActReport::Status::done;
  }
  const bool never = loaded_.what_if && !summary_.changed;
  const EngineParts& forcing = never ? loaded_.what_if->parts : conversation_.parts();
  for (const auto& [step, transition] : never ? forcing.forced : conversation_.state().chooser.forced)
    summary_.not_forced[step] = forcing.machine->transitions[transition].id;
  summary_.episodes = episodes_.take(blanks_of(loaded_.scene.initial_snapshot()));
  summary_.end = now();
  log_.finish(now());
}

}  // namespace continua
