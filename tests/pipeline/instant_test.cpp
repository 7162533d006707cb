#include "continua/pipeline/instant.h"

#include <algorithm>

#include "continua/facts/world_facts.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/pipeline/pipeline.h"
#include "support/catch.h"
#include "term/law.h"

using namespace continua;

namespace {

const char* machine_text = R"json({
  "machine": 1, "name": "m", "start": "A", "fusion": {}, "moves": { "δ": ["gesture point start"] },
  "transitions": [ { "id": "any", "from": "A", "on": ["speech *", "gesture *"], "to": "A" } ] })json";

struct Told {
  explicit Told(const std::string& text) : pipeline(machine(text), nullptr, Perspective::human) {
    state.emplace(pipeline.begin({Choice::likeliest, Random(1), {}, 0}, {}).after);
  }
  static std::shared_ptr<const Machine> machine(const std::string& text) {
    auto loaded = parse_machine(text, "m.json", WorldFacts::signature());
    if (!loaded) FAIL(loaded.error().text());
    return std::make_shared<const Machine>(std::move(*loaded));
  }
  std::string in_order(std::vector<InputEvent> events) const {
    std::stable_sort(events.begin(), events.end(),
                     [&](const InputEvent& a, const InputEvent& b) { return pipeline.comes_before(*state, a, b); });
    std::string all;
    for (const auto& event : events) all += (all.empty() ? "" : ", ") + symbol_of(event);
    return all;
  }

  Pipeline pipeline;
  std::optional<EngineState> state;
};

InputEvent event(const std::string& symbol, std::optional<Vec3> target_W = {}) {
  InputEvent one = event_of(symbol);
  one.target_W = target_W;
  return one;
}

const std::vector<InputEvent> instant = {event("gesture posack start"),
                                         event("speech yes"),
                                         event("gesture point start"),
                                         event("pointing right", Vec3(0.1, 0, 0)),
                                         event("gesture point start", Vec3(0.1, 0, 0)),
                                         event("pointing left", Vec3(0.2, 0, 0)),
                                         event("speech no")};

}  // namespace

TEST_CASE("pointing comes first, then the place of the hand, words, other gestures") {
  CHECK(Told(machine_text).in_order(instant) ==
        "gesture point start, pointing left, pointing right, gesture point start, speech no, speech yes, "
        "gesture posack start");
}

TEST_CASE("any order of telling gives the same order", "[law]") {
  const Told told(machine_text);
  const auto expected = told.in_order(instant);
  law("permutations", [&] {
    auto events = instant;
    for (std::size_t i = events.size(); i > 1; --i)
      std::swap(events[i - 1], events[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(i)))]);
    RC_ASSERT(told.in_order(events) == expected);
  });
}

TEST_CASE("a machine without fusion takes events as they are told") {
  std::string text = machine_text;
  text.erase(text.find(R"("fusion": {}, )"), std::string(R"("fusion": {}, )").size());
  CHECK(Told(text).in_order({event("speech b"), event("speech a")}) == "speech b, speech a");
}
