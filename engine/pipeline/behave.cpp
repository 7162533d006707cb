#include "continua/pipeline/behave.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "continua/behaviour/planner.h"
#include "continua/pipeline/doubt.h"
#include "continua/pipeline/lessons.h"

namespace continua {
namespace {

// The first variant that differs from the last utterance; if none differs, the first.
const std::string& fresh(const std::vector<std::string>& variants, const std::string& last) {
  const auto found = std::find_if(variants.begin(), variants.end(), [&](const auto& one) { return one != last; });
  return found == variants.end() ? variants.front() : *found;
}

void say(const Engine& engine, Tick& tick, Said said) {
  auto& last = tick.after.last_utterance;
  const std::string words = said.text = fresh(said.variants, last);
  if (engine.machine->repeats_utterances || words != last) tick.events.push_back(StepEvent(std::move(said)));
  last = words;
  for (auto& change : tick.after.beliefs.overhear(words)) tick.events.push_back(std::move(change));
}

// Makes a gesture one command to the body.
void gesture(const Engine& engine, Tick& tick, Gestured gestured) {
  auto command = plan(gestured.term, true, engine.perspective);
  tick.events.push_back(StepEvent(std::move(gestured)));
  if (!command)
    tick.events.push_back(Unplanned{words_of(command.reason())});
  else if (auto begun = engine.performer.begin(tick.after.performance, *std::move(command)))
    tick.events.push_back(GestureCommand{*begun});
}

void behave(const Engine& engine, Tick& tick, StepEvent event) {
  EngineState& state = tick.after;
  if (auto* said = std::get_if<Said>(&event)) return say(engine, tick, std::move(*said));
  if (auto* gestured = std::get_if<Gestured>(&event)) return gesture(engine, tick, std::move(*gestured));
  if (const auto* again = std::get_if<Reattended>(&event)) return tick.then(attend_again(std::move(state), *again));
  if (const auto* taught = std::get_if<Taught>(&event)) state.lessons[taught->name] = taught->because;
  if (const auto* acted = std::get_if<Acted>(&event))
    engine.performer.begin(state.performance, {++state.acts, acted->term, acted->because});
  tick.events.push_back(std::move(event));
}

}  // namespace

Tick behave(const Engine& engine, Stepped stepped) {
  Tick tick{std::move(stepped.after), {}};
  const auto* gestures = gestures_of(engine);
  const Seen seen{tick.after.shapes, gestures ? gestures->shapes : ShapeLimits()};
  for (auto& event : with_lessons(std::move(stepped.events), *engine.machine, seen, tick.after.learned))
    behave(engine, tick, std::move(event));
  tick.events.insert(tick.events.end(), std::make_move_iterator(stepped.others.begin()),
                     std::make_move_iterator(stepped.others.end()));
  return tick;
}

}  // namespace continua
