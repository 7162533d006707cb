#include "continua/pipeline/together.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "continua/perception/shown_with.h"
#include "continua/pipeline/account.h"
#include "continua/pipeline/behave.h"
#include "continua/pipeline/believe.h"
#include "continua/pipeline/doubt.h"
#include "continua/pipeline/following.h"
#include "continua/pipeline/fuse.h"
#include "continua/pipeline/step.h"

namespace continua {
namespace {

// Of the ensembles, the number of the first one's counterpart; 0 if it has none.
std::size_t counterpart(const std::vector<Ensemble>& complete, const FusionWindow& window) {
  const auto& first = complete.front().percept;
  if (!first.assured.empty() || first.again > 0 || first.resumes) return 0;
  for (std::size_t i = 1; i < complete.size(); ++i) {
    const auto& other = complete[i].percept;
    if (is_shown_with(first, other, window) || is_shown_with(other, first, window)) return i;
  }
  return 0;
}

struct Pair {
  Ensemble words, gesture;
};

// Takes both, in the state. REQUIRES that `other` is the first one's counterpart.
Pair take_pair(const Engine& engine, EngineState& state, std::size_t other) {
  const auto second = state.complete.begin() + 1;
  std::rotate(second, std::next(second, static_cast<std::ptrdiff_t>(other) - 1),
              std::next(second, static_cast<std::ptrdiff_t>(other)));
  Ensemble first = take_complete(engine, state), then = take_complete(engine, state);
  if (first.percept.event.modality != Modality::speech) std::swap(first, then);
  return {std::move(first), std::move(then)};
}

// The two inputs. The words' draws on the sources of both, and its `doubted` has the number of the words and that of
// the gesture.
std::pair<Input, Input> inputs_of(EngineState& state, const Pair& pair, const Offer& said, const Offer& shown) {
  Doubt words = doubt_of(std::move(state), pair.words, {said}, {0});
  Doubt gesture = doubt_of(std::move(words.state), pair.gesture, {shown}, {0});
  state = std::move(gesture.state);
  const auto both = [](const Term& a, const Term& b, Type type) {
    return Term::list({a.elements().front(), b.elements().front()}, std::move(type));
  };
  Input beside = shown.input, together = said.input;
  beside.symbol = beside_symbol(shown.input.symbol);
  together.symbol = together_symbol;
  together.doubted = both(words.input.doubted, gesture.input.doubted, Type::number());
  together.doubted_words = both(words.input.doubted_words, gesture.input.doubted_words, Type::text_type());
  together.doubted_meanings = both(words.input.doubted_meanings, gesture.input.doubted_meanings, Type::term());
  auto& because = together.because;
  because.insert(because.end(), beside.because.begin(), beside.because.end());
  std::sort(because.begin(), because.end());
  because.erase(std::unique(because.begin(), because.end()), because.end());
  return {std::move(beside), std::move(together)};
}

// An ensemble, the one way in which it was understood, and the input that comes of it.
struct Half {
  const Ensemble& ensemble;
  const std::vector<Offer>& offers;
  const Input& input;
};

// The records of how it was understood.
std::vector<EngineEvent> account_of(const Engine& engine, const Half& half) {
  std::vector<EngineEvent> events{account_of(half.ensemble, engine.window)};
  const auto offers = account_of(half.offers, 0);
  events.insert(events.end(), offers.begin(), offers.end());
  return events;
}

}  // namespace

std::string beside_symbol(std::string_view gesture_symbol) {
  return "beside" + std::string(gesture_symbol.substr(std::min(gesture_symbol.find(' '), gesture_symbol.size())));
}

bool goes_with_words(const Engine& engine, const EngineState& state, std::string_view gesture_symbol) {
  const auto& transitions = engine.machine->transitions;
  const auto symbol = beside_symbol(gesture_symbol);
  return std::any_of(transitions.begin(), transitions.end(), [&](const Transition& one) {
    return one.on && one.on->contains(symbol) &&
           std::find(one.from.begin(), one.from.end(), state.configuration.state) != one.from.end();
  });
}

std::optional<Tick> attended_together(const Engine& engine, const EngineState& before, const WorldSnapshot& world) {
  if (before.complete.size() < 2 || !engine.machine->knows_input(together_symbol)) return std::nullopt;
  const auto other = counterpart(before.complete, engine.window);
  if (other == 0) return std::nullopt;
  Tick tick{before, {}};
  EngineState& state = tick.after;
  state.words = with_taught(std::move(state.words), state.learned);
  const Pair pair = take_pair(engine, state, other);
  state.looked = looked_at(engine, state, pair.words.at);
  const auto said = offers_of(pair.words, dialogue_of(engine, state, world));
  const auto shown = offers_of(pair.gesture, dialogue_of(engine, state, world));
  if (said.size() > 1 || shown.size() > 1) return std::nullopt;
  const auto [beside, together] = inputs_of(state, pair, said.front(), shown.front());
  for (const auto& half : {Half{pair.gesture, shown, beside}, Half{pair.words, said, together}}) {
    const auto events = account_of(engine, half);
    tick.events.insert(tick.events.end(), events.begin(), events.end());
    tick.then(believe(engine, std::move(state), half.input, world));
    auto stepped = step_if_taken(engine, std::move(state), half.input, world);
    if (!stepped) return std::nullopt;
    tick.then(behave(engine, *std::move(stepped)));
  }
  if (const auto& sign = shown.front().sign) state.sign = sign;
  return tick;
}

}  // namespace continua
