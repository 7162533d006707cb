#include "continua/pipeline/doubt.h"

#include <fmt/format.h>

#include "continua/facts/world_facts.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/pipeline/pipeline.h"
#include "support/catch.h"

using namespace continua;

namespace {

const char* machine_text = R"json({
  "machine": 1, "name": "m", "start": "Wait",
  "confidence": { "speech stop": { "ignore": 0.01 }, "*": { "confirm": 0.4, "ignore": 0.1 } }, "near_tie": 0.05,
  "programs": { "look_at": "text -> t" }, "slots": { "doubts": "num*", "heard": "text*", "n": "num" },
  "states": { "Wait": {}, "Doubt": { "enter": [ { "say": "{head(heard)}?" } ] }, "Sure": {}, "Left": {} },
  "transitions": [
    { "id": "take", "from": "Wait", "on": "speech take", "to": "Wait", "do": [ { "act": "'take'" } ] },
    { "id": "grab", "from": "Wait", "on": "speech grab", "to": "Wait", "do": [ { "act": "'take'" } ] },
    { "id": "push", "from": "Wait", "on": "speech push", "to": "Wait", "do": [ { "act": "'push'" } ] },
    { "id": "count", "from": "Wait", "on": "speech count", "to": "Wait", "push": { "n": "1" } },
    { "id": "stop", "from": "*", "on": "speech stop", "to": "Wait", "do": [ { "say": "Stopped." } ] },
    { "id": "lost", "from": "*", "on": "refused", "to": "Wait", "do": [ { "say": "Pardon?" } ] },
    { "id": "unsure", "from": "Wait", "on": "unsure", "when": "doubted_words != ['count']", "to": "Doubt", "push": { "doubts": "doubted", "heard": "doubted_words" } },
    { "id": "look", "from": "Left", "on": "interim", "to": "Left", "do": [ { "gesture": "look_at('it')" } ] },
    { "id": "leave", "from": "Wait", "on": "speech leave", "to": "Left" },
    { "id": "yes", "from": "Doubt", "on": "speech yes", "to": "Sure", "none": true, "do": [ { "attend": "head(doubts)" } ] },
    { "id": "sure", "from": "Sure", "on": null, "to": "Wait", "pop": 1 },
    { "id": "next", "from": "Doubt", "on": "speech no", "when": "size(doubts) > 1", "to": "Doubt", "rewrite": { "doubts": "tail(doubts)", "heard": "tail(heard)" } },
    { "id": "none", "from": "Doubt", "on": "speech no", "when": "size(doubts) = 1", "to": "Wait", "pop": 1 },
    { "id": "other", "from": "Doubt", "on": ["speech push", "speech take"], "to": "Wait", "pop": 1, "do": [ { "attend": "0" } ] },
    { "id": "again", "from": "Left", "on": "speech again", "to": "Left", "do": [ { "attend": "0" } ] } ] })json";

// Says words and gives the acts, utterances and refusals that follow.
struct Play {
  Play() {
    auto loaded = parse_machine(machine_text, "m.json", WorldFacts::signature());
    if (!loaded) FAIL(loaded.error().text());
    pipeline.emplace(std::make_shared<const Machine>(std::move(*loaded)), nullptr, Perspective::human);
    state.emplace(pipeline->begin({Choice::likeliest, Random(1), {}, 0}, {}).after);
  }

  std::string say(const std::string& words, double confidence = 1, std::vector<Alternative> others = {},
                  bool final = true) {
    InputEvent event;
    event.text = words;
    event.confidence = confidence;
    event.alternatives = std::move(others);
    event.final = final;
    Tick tick = pipeline->tick(*state, event, {});
    std::string told;
    const auto add = [&](const std::string& what) { told += (told.empty() ? "" : "; ") + what; };
    for (const auto& one : tick.events) {
      const auto* step = std::get_if<StepEvent>(&one);
      if (!step) continue;
      if (const auto* said = std::get_if<Said>(step)) add(said->text);
      if (const auto* acted = std::get_if<Acted>(step)) add("act " + print(acted->term));
      if (const auto* gestured = std::get_if<Gestured>(step)) add("shows " + print(gestured->term));
      if (const auto* refused = std::get_if<RefusedInput>(step)) add(refused->reason);
      if (const auto* trouble = std::get_if<Trouble>(step)) add(trouble->message);
    }
    state = std::move(tick.after);
    return told;
  }

  std::optional<Pipeline> pipeline;
  std::optional<EngineState> state;
};

}  // namespace

TEST_CASE("an unsure input waits until it is asked about, and then has its effect or none") {
  Play play;
  CHECK(play.say("push", 0.4) == "act 'push'");
  CHECK(play.say("push", 0.3) == "push?");
  CHECK(play.say("yes") == "act 'push'");
  CHECK(play.say("push", 0.3) == "push?");
  CHECK(play.say("no") == "");
  CHECK(play.state->configuration.stack.depth() == 1);
}

TEST_CASE("an input below the machine's threshold for it leaves only the reason") {
  Play play;
  CHECK(play.say("push", 0.05) == "its confidence 0.05 is below 0.1: the machine ignores such a 'speech push'");
  CHECK(play.say("stop", 0.05) == "Stopped.");
}

TEST_CASE("an unsure input counts where the machine does not ask") {
  Play play;
  CHECK(play.say("count", 0.2) == "");
  CHECK(play.state->configuration.stack.depth() == 2);
}

TEST_CASE("alternatives that are about as likely are asked about if they lead elsewhere") {
  Play play;
  CHECK(play.say("take", 0.5, {{"push", 0.48}}) == "take?");
  CHECK(play.say("no") == "push?");
  CHECK(play.say("yes") == "act 'push'");
  CHECK(play.say("take", 0.5, {{"count", 0.48}}) == "take?");
  CHECK(play.say("no") == "count?");
  CHECK(play.say("no") == "");
  CHECK(play.say("take", 0.5, {{"grab", 0.49}}) == "act 'take'");
  CHECK(play.say("take", 0.5, {{"push", 0.44}}) == "act 'take'");
  CHECK(play.say("take", 0.5, {{"fly", 0.49}}) == "act 'take'");
}

TEST_CASE("an input can be attended to once more, in the state that the step leads to") {
  Play play;
  CHECK(play.say("push", 0.3) == "push?");
  CHECK(play.say("take") == "act 'take'");
  CHECK(play.say("leave") == "");
  CHECK(play.say("again") == "the same input is attended to more than 3 times again");
}

TEST_CASE("words that are not final change nothing, and are refused by no one") {
  Play play;
  CHECK(play.say("push", 1, {}, false) == "");
  CHECK(play.say("leave") == "");
  CHECK(play.say("push", 1, {}, false) == "shows look_at('it')");
}
