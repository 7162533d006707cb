// Speech on its way through the pipeline of a machine with a lexicon.
#include "continua/machine_file/machine_loader.h"
#include "continua/pipeline/pipeline.h"
#include "language/english.h"

using namespace continua;

namespace {

const char* any_text = R"json({
  "machine": 1, "name": "m", "start": "A", "lexicon": "english", "fusion": { "before": 2, "after": 1, "lateness": 0 },
  "transitions": [ { "id": "any", "from": "A", "on": "speech *", "to": "A" } ] })json";

// Tells of each move the kinds of those around it.
const char* telling_text = R"json({
  "machine": 1, "name": "m", "start": "A", "lexicon": "english", "fusion": { "before": 2, "after": 1, "lateness": 0 },
  "transitions": [ { "id": "any", "from": "A", "on": "speech *", "to": "A",
    "do": [ { "say": "{move} {following} {later}" } ] } ] })json";

// Tells of each move the words that join it to the one before it; nothing where there are none.
const char* joining_text = R"json({
  "machine": 1, "name": "m", "start": "A", "lexicon": "english", "fusion": { "before": 2, "after": 1, "lateness": 0 },
  "transitions": [ { "id": "any", "from": "A", "on": "speech *", "to": "A",
    "do": [ { "say": "{move} {joined}" } ] } ] })json";

// Attends to commands a second time, in another state.
const char* twice_text = R"json({
  "machine": 1, "name": "m", "start": "A", "lexicon": "english", "fusion": { "before": 2, "after": 1, "lateness": 0 },
  "transitions": [
    { "id": "other", "from": "A", "on": "speech *", "to": "A", "do": [ { "say": "A {move}" } ] },
    { "id": "command", "from": "A", "on": "speech V", "to": "B", "rank": 1, "do": [ { "attend": "0" } ] },
    { "id": "again", "from": "B", "on": "speech *", "to": "A", "do": [ { "say": "B {move}" } ] } ] })json";

Pipeline pipeline(const char* machine_text = any_text) {
  auto loaded = parse_machine(machine_text, "m.json", WorldFacts::signature());
  if (!loaded) FAIL(loaded.error().text());
  auto language = std::make_shared<Language>();
  language->lexicon = english();
  return {std::make_shared<const Machine>(std::move(*loaded)), std::move(language), Perspective::human};
}

InputEvent said(const std::string& words) {
  InputEvent event;
  event.text = words;
  return event;
}

// The understood moves, "; " between them: their kinds and readings.
std::string understood(const Tick& tick) {
  std::string all;
  for (const auto& event : tick.events)
    if (const auto* one = std::get_if<Understood>(&event))
      all += (all.empty() ? "" : "; ") + one->move.kind + " " +
             (one->move.readings.empty() ? "" : print(one->move.readings[one->move.chosen].term));
  return all;
}

std::string told(const Tick& tick) {
  std::string all;
  for (const auto& event : tick.events)
    if (const auto* step = std::get_if<StepEvent>(&event)) {
      if (const auto* one = std::get_if<Said>(step)) all += (all.empty() ? "" : "; ") + one->text;
      if (const auto* trouble = std::get_if<Trouble>(step)) all += " !" + trouble->message;
    }
  return all;
}

std::string told_by(const char* machine_text, const std::string& words) {
  const Pipeline engine = pipeline(machine_text);
  const Tick begun = engine.begin({Choice::likeliest, Random(1), {}, 0}, {});
  return told(engine.tick(begun.after, said(words), {}));
}

}  // namespace

TEST_CASE("speech that waits is understood by the words that are known once it is complete") {
  const Pipeline engine = pipeline();
  const Tick begun = engine.begin({Choice::likeliest, Random(1), {}, 0}, {});
  Tick heard = engine.receive(begun.after, said("hoist that"), {});
  CHECK(heard.after.complete.empty());
  CHECK(understood(engine.settle(heard.after, {})) == "N that(\\x. true)");

  heard.after.learned.programs.emplace("hoist", Program{parse_term("\\x: e. [x]", {}).value()});
  CHECK(understood(engine.settle(heard.after, {})) == "V hoist(that(\\x. true))");
}

TEST_CASE("an utterance is as many moves as it has fragments") {
  const Pipeline engine = pipeline();
  const Tick begun = engine.begin({Choice::likeliest, Random(1), {}, 0}, {});
  CHECK(understood(engine.tick(begun.after, said("no the cup"), {})) == "n no; N the(\\x. cup(x))");
}

TEST_CASE("each move knows which follow in its sentence, and which in later ones") {
  CHECK(told_by(telling_text, "no the cup. yes") == "n ['N'] ['y']; N [] ['y']; y [] []");
}

TEST_CASE("a move has the words that join it to the one before it in its sentence") {
  CHECK(told_by(joining_text, "take the cup and then push it, lift it. yes") == "V and; V ");
}

TEST_CASE("a move that is attended to once more is not heard with the moves before it, and the rest follows") {
  CHECK(told_by(twice_text, "no. take the cup. yes") == "A n; B V; A y");
  CHECK(told_by(twice_text, "take the cup. yes. take the cup") == "B V; A y; B V");
}
