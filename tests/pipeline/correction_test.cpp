// The engine goes on from another avatar's observed deeds.
#include "continua/facts/world_facts.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/pipeline/pipeline.h"
#include "support/catch.h"

using namespace continua;

namespace {

const char* machine_text = R"json({
  "machine": 1, "name": "m", "start": "Wait", "repeat_utterances": false,
  "programs": { "lift": "e -> t", "cup": "e", "knife": "e" },
  "slots": { "indicated": "e", "grasped": { "type": "e", "persists": true } },
  "memory": { "count": { "type": "num", "initial": "0" } },
  "beliefs": { "concepts": { "X": { "word": "cup" }, "Y": { "word": "knife" }, "GO": {} },
               "evidence": [{ "inputs": ["speech x"], "concepts": ["GO"], "levels": [0.5, 1] }], "overheard": 0.25 },
  "states": { "Wait": {}, "Ask": { "enter": [{ "say": "The cup?" }] }, "Held": { "enter": [{ "say": "Never." }] } },
  "transitions": [
    { "id": "ask", "from": "Wait", "on": "speech x", "to": "Ask", "push": { "indicated": "cup" }, "do": [{ "remember": { "count": "count + 1" } }] },
    { "id": "again", "from": "Ask", "on": "speech x", "to": "Ask", "push": { "indicated": "cup" } } ],
  "implied": [
    { "when": "size(observed_acts) >= 1 and in_state = 'Wait'", "to": "Held",
      "stack": [{ "flush": {} }, { "push": { "grasped": "argument(head(observed_acts), 0)", "indicated": "indicated" } }] },
    { "when": "observed_speech = 'The knife?' and size(observed_gestures) = 0", "to": "Ask", "stack": [{ "push": { "indicated": "knife" } }, { "push": {} }] }
  ] })json";

struct Play {
  Play() {
    auto loaded = parse_machine(machine_text, "m.json", WorldFacts::signature());
    if (!loaded) FAIL(loaded.error().text());
    machine = std::make_shared<const Machine>(std::move(*loaded));
    pipeline.emplace(machine, nullptr, Perspective::human);
    before.emplace(pipeline->begin({Choice::likeliest, Random(1), {}, 0}, {}).after);
    event.text = "x";
    after.emplace(pipeline->tick(*before, event, {}).after);
  }

  void correct(const ObservedMoves& observed) {
    auto tick = pipeline->corrected(*before, *after, event, observed, {});
    state.emplace(std::move(tick.after));
    events = std::move(tick.events);
  }

  std::string where() const { return machine->states[state->configuration.state].name; }
  std::string slot(const std::string& name) const {
    return print(state->configuration.stack.top()[machine->slot_index.at(name)].value);
  }
  std::string certainties() const {
    std::string all;
    for (const auto& one : events)
      if (const auto* change = std::get_if<BeliefChange>(&one)) all += change->name + " ";
    return all;
  }
  const Corrected* corrected() const { return events.empty() ? nullptr : std::get_if<Corrected>(&events.back()); }

  std::shared_ptr<const Machine> machine;
  std::optional<Pipeline> pipeline;
  InputEvent event;
  std::optional<EngineState> before, after, state;
  std::vector<EngineEvent> events;
};

Term lift_knife() {
  return Term::apply(Term::constant("lift", Type::function(Type::entity(), Type::truth())), Term::entity("knife"));
}

}  // namespace

TEST_CASE("where nothing was observed, nothing has happened, but for what was perceived") {
  Play play;
  play.correct({});
  CHECK(play.where() == "Wait");
  CHECK(play.slot("indicated") == "null");
  CHECK(play.state->configuration.stack.depth() == 1);
  REQUIRE(play.corrected());
  CHECK(play.corrected()->implied == 0);
  CHECK(play.machine->states[play.corrected()->from].name == "Ask");
  // The register and the certainty of the input stay; the avatar has not said "cup".
  CHECK(print((*play.state->configuration.memory)[0].value) == "1");
  CHECK(play.certainties() == "X ");
  CHECK(play.state->last_utterance.empty());
}

TEST_CASE("the first row that holds before the input makes state and stack, without entering") {
  Play play;
  play.correct({{"The knife?"}, {}, {}});
  CHECK(play.where() == "Ask");
  CHECK(play.slot("indicated") == "knife");
  CHECK(play.state->configuration.stack.depth() == 3);
  CHECK(play.corrected()->implied == 2);
  CHECK(play.state->last_utterance == "The knife?");
  CHECK(play.certainties() == "X Y ");

  play.correct({{"Fine.", "There."}, {}, {lift_knife()}});
  CHECK(play.where() == "Held");
  CHECK(play.slot("grasped") == "knife");
  CHECK(play.slot("indicated") == "null");
  CHECK(play.corrected()->implied == 1);
  CHECK(play.state->last_utterance == "There.");
}

TEST_CASE("symbols that are made get ids of their own, and are told before the correction") {
  Play play;
  const int next = play.after->configuration.next.symbol;
  play.correct({{"The knife?"}, {}, {}});
  std::vector<int> made;
  for (const auto& event : play.events)
    if (const auto* step = std::get_if<StepEvent>(&event))
      if (const auto* symbol = std::get_if<MadeSymbol>(step)) made.push_back(symbol->id);
  CHECK(made == std::vector<int>{next, next + 1});
  CHECK(play.corrected()->stack == next + 1);
  CHECK(play.corrected()->depth == 3);
}

TEST_CASE("where no row holds the engine stays where it is, but has said what was observed") {
  Play play;
  play.correct({{"The knife?"}, {lift_knife()}, {}});
  CHECK(play.where() == "Ask");
  CHECK(play.slot("indicated") == "cup");
  CHECK_FALSE(play.corrected());
  CHECK(play.state->last_utterance == "The knife?");
}
