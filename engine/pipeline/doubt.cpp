#include "continua/pipeline/doubt.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "continua/pipeline/step.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

// More than can be asked about one after the other.
constexpr std::size_t most_doubted = 64;

// To give up a question and to come between those that wait takes two. More than three go round in a circle.
constexpr int most_times_again = 3;

std::vector<std::string> acts_of(const Tick& tick) {
  std::vector<std::string> acts;
  for (const auto& event : tick.events)
    if (const auto* step = std::get_if<StepEvent>(&event))
      if (const auto* acted = std::get_if<Acted>(step)) acts.push_back(print(acted->term));
  return acts;
}

// The alternative alone, as if the recogniser were sure of it.
Ensemble sure(Ensemble ensemble, std::size_t which) {
  auto& percept = ensemble.percept;
  percept.event = alternative(percept.event, which);
  percept.event.alternatives.clear();
  percept.event.confidence = 1;
  percept.readings = nullptr;
  return ensemble;
}

}  // namespace

bool lead_elsewhere(const Tick& a, const Tick& b) {
  const auto &one = a.after.configuration, &other = b.after.configuration;
  return one.state != other.state || !(one.stack == other.stack) || acts_of(a) != acts_of(b);
}

bool is_refused(const Tick& tick) {
  return std::any_of(tick.events.begin(), tick.events.end(), [](const EngineEvent& event) {
    const auto* step = std::get_if<StepEvent>(&event);
    return step && std::holds_alternative<RefusedInput>(*step);
  });
}

Doubt doubt_of(EngineState state, const Ensemble& ensemble, const std::vector<Offer>& offers,
               const std::vector<std::size_t>& doubted) {
  Input input = offers[doubted.front()].input;
  input.symbol = unsure_symbol;
  std::vector<Term> numbers, words, meanings;
  for (const auto which : doubted) {
    const auto& offer = offers[which];
    const int number = ++state.doubts;
    state.doubted.insert_or_assign(number, sure(ensemble, offer.alternative));
    numbers.push_back(Term::number(number));
    const auto& said = state.doubted.find(number)->second.percept.event.text;
    words.push_back(Term::text(said));
    meanings.push_back(offer.input.meaning.is_null() ? Term::text(offer.move.kind) : offer.input.meaning);
  }
  while (state.doubted.size() > most_doubted) state.doubted.erase(std::next(state.doubted.begin()));
  input.doubted = Term::list(std::move(numbers), Type::number());
  input.doubted_words = Term::list(std::move(words), Type::text_type());
  input.doubted_meanings = Term::list(std::move(meanings), Type::term());
  return {std::move(state), std::move(input)};
}

Tick attend_again(EngineState state, const Reattended& again) {
  const auto found = state.doubted.find(again.number);
  const auto trouble = [&](std::string why) {
    Tick tick{std::move(state), {}};
    tick.events.push_back(StepEvent(Trouble{std::move(why)}));
    return tick;
  };
  if (found == state.doubted.end()) return trouble(fmt::format("no input waits under the number {}", again.number));
  Ensemble ensemble = found->second;
  auto& percept = ensemble.percept;
  if (again.number == 0 && ++percept.again > most_times_again)
    return trouble(fmt::format("the same input is attended to more than {} times again", most_times_again));
  if (again.number != 0) {
    percept.assured = again.because;
    state.doubted.erase(found);
  }
  ensemble.at = SimTime::from_seconds(again.now_s);
  state.complete.insert(state.complete.begin(), std::move(ensemble));
  return {std::move(state), {}};
}

bool comes_again(EngineState& state, const Offer& move) {
  auto& under_way = state.doubted.at(0).percept;
  const bool again = !state.complete.empty() && state.complete.front().percept.again > 0 &&
                     state.complete.front().percept.serial == under_way.serial;
  if (again)
    state.complete.front().percept.resumes = MovePlace{move.alternative, move.fragment};
  else
    under_way.again = 0;
  return again;
}

}  // namespace continua
