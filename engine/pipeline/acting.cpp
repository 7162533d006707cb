#include "continua/pipeline/acting.h"

#include <type_traits>
#include <utility>

namespace continua {

namespace {

// The end of an act, or its beginning; nothing if the event is neither.
std::optional<ActEnd> news_of(const PerformanceEvent& event) {
  if (const auto* begun = std::get_if<ActBegun>(&event)) return ActEnd{.act = begun->act, .status = ActStatus::started};
  if (const auto* end = std::get_if<ActEnd>(&event)) return *end;
  return std::nullopt;
}

}  // namespace

std::string symbol_of(const ActEnd& news) { return "act " + name_of(news.status); }

Input to_input(const ActEnd& news, int serial, SimTime now) {
  Input input;
  input.serial = serial;
  input.because = news.act.because;
  input.symbol = symbol_of(news);
  input.now_s = now.seconds();
  input.act = news.act.program;
  if (news.reason.empty()) return input;
  input.reason = Term::text(words_of(news.reason));
  input.why = Term::text(name_of(news.reason.code));
  std::vector<Term> objects;
  for (const auto& object : news.reason.objects) objects.push_back(Term::entity(object));
  input.concerned = Term::list(std::move(objects), Type::entity());
  return input;
}

Performed perform(const Engine& engine, EngineState state, const WorldSnapshot& world) {
  Tick tick{std::move(state), {}};
  while (const auto next = engine.performer.next(tick.after.performance, world)) {
    std::visit(
        [&](const auto& event) {
          if constexpr (std::is_constructible_v<EngineEvent, decltype(event)>) tick.events.push_back(event);
        },
        *next);
    const auto news = news_of(*next);
    if (news && engine.machine->knows_input(symbol_of(*news))) return {std::move(tick), news};
  }
  return {std::move(tick), std::nullopt};
}

}  // namespace continua
