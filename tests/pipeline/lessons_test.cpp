// Lessons learned and forgotten by machines, and their effect from then on.
#include "continua/pipeline/lessons.h"

#include <fmt/format.h>

#include "continua/facts/world_facts.h"
#include "continua/learning/learning_file.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/pipeline/pipeline.h"
#include "support/catch.h"

using namespace continua;

namespace {

const char* machine_text = R"json({
  "machine": 1, "name": "m", "start": "A",
  "programs": { "grasp": "e -> t", "lift": "e -> t", "put": "e -> loc -> t", "cup": "e", "knife": "e", "hoist": "e -> t", "loop": "t" },
  "memory": { "acts": { "type": "t*", "initial": "[grasp(cup), lift(cup)]" } },
  "transitions": [
    { "id": "teach", "from": "A", "on": "speech teach", "to": "A", "do": [
      { "learn": { "gesture": "'claw'", "means": "grasp(cup)" } }, { "learn": { "word": "'raise up'", "acts": "acts" } } ] },
    { "id": "noun", "from": "A", "on": "speech noun", "to": "A", "do": [
      { "learn": { "noun": "'bob'", "means": "\\x: e. x = knife" } }, { "learn": { "word": "'tidy'", "acts": "acts", "fixed": true } },
      { "learn": { "noun": "'bad'", "means": "knife" } },      { "forget": { "noun": "'bob'" } } ] },
    { "id": "again", "from": "A", "on": "speech again", "to": "A", "do": [{ "learn": { "gesture": "'claw'", "means": "lift(cup)" } }] },
    { "id": "bad", "from": "A", "on": "speech bad", "to": "A", "do": [
      { "learn": { "word": "'none'", "acts": "[]" } },
      { "learn": { "word": "''", "acts": "acts" } }, { "learn": { "gesture": "null", "means": "cup" } },
      { "learn": { "gesture": "'g'", "means": "null" } }] },
    { "id": "taken", "from": "A", "on": "speech taken", "to": "A", "do": [
      { "learn": { "word": "'hoist'", "acts": "acts" } }, { "learn": { "word": "'size'", "acts": "acts" } },
      { "learn": { "word": "'acts'", "acts": "acts" } }, { "say": "{learned('size')} {meaning_of('size')}" } ] },
    { "id": "unsize", "from": "A", "on": "speech unsize", "to": "A", "do": [{ "forget": { "word": "'size'" } }] },
    { "id": "ask", "from": "A", "on": "speech ask", "to": "A", "do": [
      { "say": "{learned('claw')} {learned('raise up')} {learned('other')}" }, { "say": "{meaning_of('claw')}" },
      { "say": "{meaning_of('raise up')}" }] },
    { "id": "forget", "from": "A", "on": "speech forget", "to": "A", "do": [
      { "forget": { "gesture": "'claw'" } }, { "forget": { "word": "'claw'" } }, { "forget": { "gesture": "null" } }] },
    { "id": "all", "from": "A", "on": "speech all", "to": "A", "do": [{ "forget": "all" }] } ] })json";

struct Play {
  explicit Play(Learned learned = {}) {
    auto loaded = parse_machine(machine_text, "m.json", WorldFacts::signature());
    if (!loaded) FAIL(loaded.error().text());
    pipeline.emplace(std::make_shared<const Machine>(std::move(*loaded)), nullptr, Perspective::human);
    state.emplace(pipeline->begin({Choice::likeliest, Random(1), {}, 0}, {}, std::move(learned)).after);
  }

  // A line for each lesson, each lesson forgotten, each utterance and each failed effect.
  std::string say(const std::string& words) {
    InputEvent event;
    event.text = words;
    Tick tick = pipeline->tick(*state, event, {});
    std::string happened;
    for (const auto& one : tick.events) {
      const auto* step = std::get_if<StepEvent>(&one);
      if (!step) continue;
      if (const auto* taught = std::get_if<Taught>(step))
        happened += fmt::format("+ {} {}: {} because {}\n", name_of(taught->of), taught->name, print(taught->value),
                                taught->because.size());
      if (const auto* lost = std::get_if<Forgotten>(step))
        happened += fmt::format("- {} {}: {}\n", name_of(lost->of.value()), lost->name, print(lost->value));
      if (const auto* said = std::get_if<Said>(step)) happened += said->text + "\n";
      if (const auto* trouble = std::get_if<Trouble>(step)) happened += trouble->message + "\n";
    }
    state = std::move(tick.after);
    return happened;
  }

  std::optional<Pipeline> pipeline;
  std::optional<EngineState> state;
};

}  // namespace

TEST_CASE("what is taught is known from then on, until it is forgotten") {
  Play play;
  CHECK(play.say("ask") == "false false false\n");
  CHECK(play.say("teach") ==
        "+ gesture claw: grasp(cup) because 1\n+ word raise up: \\x. [grasp(x), lift(x)] because 1\n");
  CHECK(play.say("ask") == "true true false\ngrasp(cup)\n\\x. [grasp(x), lift(x)]\n");
  CHECK(play.say("again") == "+ gesture claw: lift(cup) because 1\n");
  CHECK(play.say("forget") == "- gesture claw: lift(cup)\n");
  CHECK(play.say("ask") == "false true false\n\\x. [grasp(x), lift(x)]\n");
  CHECK(play.say("forget").empty());
  play.say("teach");
  CHECK(play.say("all") == "- gesture claw: grasp(cup)\n- word raise up: \\x. [grasp(x), lift(x)]\n");
  CHECK(play.state->learned == Learned());
}

TEST_CASE("a noun is taught by a condition, and the acts of a word may keep their objects") {
  Play play;
  const auto told = play.say("noun");
  CHECK(told.find("+ noun bob: \\x. x = knife") != std::string::npos);
  CHECK(told.find("+ word tidy: [grasp(cup), lift(cup)]") != std::string::npos);
  CHECK(told.find("'bad' is not learned: knife is no condition on things") != std::string::npos);
  CHECK(told.find("- noun bob: \\x. x = knife") != std::string::npos);
}

TEST_CASE("what cannot be learned is told, and nothing is learned by it") {
  Play play;
  CHECK(play.say("bad") ==
        "'none' is not learned: nothing was done; expected one act or more\n"
        "'' is not learned: nothing is learned without a name\n");
  CHECK(play.state->learned == Learned());
}

TEST_CASE("a word that is a name of the machine's or of a fact gets a name of its own in terms") {
  Play play;
  CHECK(
      play.say("taken").starts_with("+ word hoist_taught: \\x. [grasp(x), lift(x)] because 1\n"
                                    "+ word size_taught: \\x. [grasp(x), lift(x)] because 1\n"
                                    "+ word acts_taught: \\x. [grasp(x), lift(x)] because 1\n"));
  CHECK(play.state->learned.program_called("size") == play.state->learned.program_called("size_taught"));
  CHECK(play.say("unsize") == "- word size_taught: \\x. [grasp(x), lift(x)]\n");
  CHECK(play.state->learned.program_called("size") == nullptr);
  CHECK(play.state->learned.programs.at("hoist_taught").word == "hoist");
}

TEST_CASE("a run begins with what was taught before") {
  Play first;
  first.say("teach");
  Play second(first.state->learned);
  CHECK(second.say("ask") == "true true false\ngrasp(cup)\n\\x. [grasp(x), lift(x)]\n");
}

TEST_CASE("the act of a learned program is done as the acts that it comes to") {
  Play play;
  play.say("teach");
  const auto type = play.state->learned.programs.at("raise up").type();
  const auto act = Term::apply(Term::constant("raise up", type), Term::entity("knife"));
  const ShownShapes none;
  const Seen seen{none, {}};
  const auto events = with_lessons({Acted{act, {7}}, Said{"Okay.", {"Okay."}, {}}}, play.pipeline->machine(), seen,
                                   play.state->learned);
  REQUIRE(events.size() == 4);
  CHECK(print(std::get<Applied>(events[0]).application.result) == "[grasp(knife), lift(knife)]");
  CHECK(print(std::get<Acted>(events[1]).term) == "grasp(knife)");
  CHECK(print(std::get<Acted>(events[2]).term) == "lift(knife)");
  CHECK(std::get<Acted>(events[2]).because == std::vector<int>{7});
  CHECK(std::get<Said>(events[3]).text == "Okay.");
}
