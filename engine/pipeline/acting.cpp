#include "continua/pipeline/acting.h"

#include <utility>

namespace continua {

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

Performed perform(const Engine& engine, EngineState state, const WorldSnapshot& world) {
  Tick tick{std::move(state), {}};
  while (const auto next = engine.performer.next(tick.after.performance, world)) {
    std::visit([&](const auto& event) { tick.events.push_back(event); }, *next);
    const auto* end = std::get_if<ActEnd>(&*next);
    if (end && engine.machine->knows_input(symbol_of(*end))) return {std::move(tick), *end};
  }
  return {std::move(tick), std::nullopt};
}

}  // namespace continua
