// Speech on its way through the pipeline of a machine with a lexicon.
#include "continua/machine_file/machine_loader.h"
#include "continua/pipeline/pipeline.h"
#include "language/english.h"

using namespace continua;

namespace {

const char* machine_text = R"json({
  "machine": 1, "name": "m", "start": "A", "lexicon": "english", "fusion": { "before": 2, "after": 1, "lateness": 0 },
  "transitions": [ { "id": "any", "from": "A", "on": "speech *", "to": "A" } ] })json";

Pipeline pipeline() {
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
