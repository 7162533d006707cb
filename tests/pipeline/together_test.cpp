#include "continua/pipeline/together.h"

#include "continua/facts/world_facts.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/pipeline/pipeline.h"
#include "support/catch.h"

using namespace continua;

namespace {

const char* machine_text = R"json({
  "machine": 1, "name": "m", "start": "Wait", "fusion": { "pause": 1 },
  "slots": { "doubts": "num*" }, "memory": { "shown": { "type": "text" } },
  "transitions": [
    { "id": "remember", "from": "Wait", "on": "beside *", "to": "Wait", "do": [ { "remember": { "shown": "gesture" } } ] },
    { "id": "contradicted", "from": "Wait", "on": "together", "when": "shown != said", "to": "Doubt", "push": { "doubts": "doubted" }, "do": [ { "say": "{said} or {shown}?" } ] },
    { "id": "heard", "from": "Wait", "on": "speech *", "to": "Wait", "do": [ { "say": "Heard {said}." } ] },
    { "id": "seen", "from": "Wait", "on": ["gesture push start", "gesture lift start"], "to": "Wait", "do": [ { "say": "Seen {gesture}, {if(shown = null, 'nothing', shown)} remembered." } ] },
    { "id": "words", "from": "Doubt", "on": "speech words", "to": "Wait", "none": true, "do": [ { "attend": "head(doubts)" } ] },
    { "id": "hand", "from": "Doubt", "on": "speech hand", "to": "Wait", "none": true, "do": [ { "attend": "last(doubts)" } ] } ] })json";

InputEvent event(double t_s, const std::string& words, const std::string& gesture = "") {
  InputEvent event;
  event.t = SimTime::from_seconds(t_s);
  event.text = words;
  if (gesture.empty()) event.until = SimTime::from_seconds(t_s + 0.5);
  if (!gesture.empty()) {
    event.modality = Modality::gesture;
    event.name = gesture;
    event.phase = "start";
  }
  return event;
}

// The utterances after the events, each of which is received at its time.
std::string said_after(const std::vector<InputEvent>& events) {
  auto loaded = parse_machine(machine_text, "m.json", WorldFacts::signature());
  if (!loaded) FAIL(loaded.error().text());
  const Pipeline pipeline(std::make_shared<const Machine>(std::move(*loaded)), nullptr, Perspective::human);
  Tick tick = pipeline.begin({Choice::likeliest, Random(1), {}, 0}, {});
  std::string told;
  const auto take = [&](Tick next) {
    for (const auto& one : next.events)
      if (const auto* step = std::get_if<StepEvent>(&one))
        if (const auto* said = std::get_if<Said>(step)) told += (told.empty() ? "" : " ") + said->text;
    tick.after = std::move(next.after);
    while (!tick.after.complete.empty()) {
      Tick more = pipeline.attend(std::move(tick.after), {});
      for (const auto& one : more.events)
        if (const auto* step = std::get_if<StepEvent>(&one))
          if (const auto* said = std::get_if<Said>(step)) told += (told.empty() ? "" : " ") + said->text;
      tick.after = std::move(more.after);
    }
  };
  const auto wait_until = [&](SimTime t) {
    for (auto due = pipeline.due(tick.after); due && *due < t; due = pipeline.due(tick.after))
      take(pipeline.wake(std::move(tick.after), *due));
  };
  for (const auto& each : events) {
    wait_until(each.t);
    take(pipeline.receive(std::move(tick.after), each, {}));
  }
  wait_until(SimTime::from_seconds(100));
  return told;
}

}  // namespace

TEST_CASE("the machine takes words, and a gesture that is made before they end, together") {
  CHECK(said_after({event(1, "lift"), event(1.2, "", "push")}) == "lift or push?");
  CHECK(said_after({event(1, "lift"), event(1.2, "", "push"), event(3, "words")}) == "lift or push? Heard lift.");
  CHECK(said_after({event(1, "lift"), event(1.2, "", "push"), event(3, "hand")}) ==
        "lift or push? Seen push, push remembered.");
}

TEST_CASE("where it does not, they are attended to one by one, and nothing is remembered") {
  CHECK(said_after({event(1, "push"), event(1.2, "", "push")}) == "Heard push. Seen push, nothing remembered.");
  CHECK(said_after({event(1, "lift"), event(1.6, "", "push")}) == "Heard lift. Seen push, nothing remembered.");
}
