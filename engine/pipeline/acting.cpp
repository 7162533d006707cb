#include "continua/pipeline/acting.h"

#include <utility>

#include <fmt/format.h>

#include "continua/behaviour/planner.h"
#include "continua/pipeline/pipeline.h"

namespace continua {
namespace {

// An act may be answered with another one; those that answer each other at once would do so forever.
constexpr int most_ends = 100;

}  // namespace

std::string symbol_of(const ActEnd& end) { return "act " + name_of(end.status); }

Input to_input(const ActEnd& end, int serial, SimTime now) {
  Input input;
  input.serial = serial;
  input.because = end.act.because;
  input.symbol = symbol_of(end);
  input.now_s = now.seconds();
  input.act = end.act.program;
  if (end.reason.empty()) return input;
  input.reason = Term::text(words_of(end.reason));
  input.why = Term::text(name_of(end.reason.code));
  std::vector<Term> objects;
  for (const auto& object : end.reason.objects) objects.push_back(Term::entity(object));
  input.concerned = Term::list(std::move(objects), Type::entity());
  return input;
}

// A gesture is one command; an act is performed from its voxemes, in `perform`.
void Pipeline::gesture(EngineState& state, const Term& gesture, std::vector<EngineEvent>& events) {
  auto command = plan(gesture, true, perspective_);
  if (!command) return events.push_back(Unplanned{words_of(command.reason())});
  if (auto begun = performer_.begin(state.performance, *std::move(command))) events.push_back(GestureCommand{*begun});
}

// All that can be done before the body has something to report. What comes of an act is offered to the automaton if it
// knows the symbol, and may have it do something else.
void Pipeline::perform(EngineState& state, const WorldSnapshot& world, std::vector<EngineEvent>& events) {
  int ends = 0;
  while (const auto next = performer_.next(state.performance, world)) {
    std::visit([&](const auto& event) { events.push_back(event); }, *next);
    const auto* end = std::get_if<ActEnd>(&*next);
    if (!end || !machine_->knows_input(symbol_of(*end))) continue;
    if (++ends > most_ends) {
      events.push_back(StepEvent(Trouble{fmt::format("more than {} acts end at once", most_ends)}));
      return;
    }
    const Input input = to_input(*end, ++state.inputs, world.t);
    events.push_back(Perceived{input.serial, input.symbol, end->act.number});
    offer(state, {&input, 1}, events);
  }
}

Tick Pipeline::reported(const EngineState& before, const std::vector<ActReport>& reports, const WorldSnapshot& world) {
  Tick tick{before, {}};
  EngineState& state = tick.after;
  methods_.see(&world, &state.chooser.random, &state.learned);
  for (const auto& report : reports) performer_.reported(state.performance, report);
  perform(state, world, tick.events);
  return tick;
}

}  // namespace continua
