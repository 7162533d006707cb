#include "continua/pipeline/pipeline.h"

#include <fmt/format.h>

#include "continua/facts/world_facts.h"
#include "continua/machine_file/machine_loader.h"
#include "support/catch.h"

using namespace continua;

namespace {

const char* machine_text = R"json({
  "machine": 1, "name": "m", "start": "Wait", "choice": "unique", "minimum_confidence": 0.5, "repeat_utterances": false,
  "programs": { "grasp": "e -> t", "reach": "e -> t", "fly": "e -> t" },
  "slots": { "indicated": "e" },
  "inputs": { "POINT": ["gesture right point start"] },
  "beliefs": { "concepts": { "point": {}, "this": { "word": "this" } },
    "evidence": [ { "inputs": ["POINT"], "concepts": ["point"], "levels": [0.5, 1] } ],
    "answers": [ { "inputs": ["speech no"], "about": "'gesture right point start'", "set": 0 } ], "overheard": 0.5 },
  "define": { "nearest": "head(sort_by(scene, \\x. distance(position(x), target)))" },
  "states": { "Wait": {}, "Asked": { "enter": [ { "say": "This?" }, { "gesture": "reach(indicated)" } ] } },
  "transitions": [
    { "id": "point", "from": ["Wait", "Asked"], "on": "POINT", "to": "Asked", "push": { "indicated": "nearest" } },
    { "id": "yes", "from": "Asked", "on": "speech yes", "to": "Wait", "do": [ { "act": "grasp(indicated)" } ] },
    { "id": "well", "from": "*", "on": "speech well", "to": "Wait", "do": [ { "say": ["Well?", "So?"] } ] },
    { "id": "so", "from": "*", "on": "speech so", "to": "Wait", "do": [ { "say": "So?" } ] },
    { "id": "fly", "from": "Asked", "on": "speech fly", "to": "Wait", "do": [ { "act": "fly(indicated)" } ] },
    { "id": "failed", "from": "Wait", "on": "act blocked", "to": "Wait", "do": [ { "say": "Sorry, {reason}." } ] } ] })json";

WorldSnapshot world() {
  WorldSnapshot snapshot;
  for (const double x : {0.1, 0.3}) {
    ObjectState object;
    object.name = x < 0.2 ? "near_one" : "far_one";
    object.half_extents_m = Vec3(0.03, 0.03, 0.03);
    object.p_WO = Vec3(x, 0, 0.03);
    snapshot.objects.push_back(object);
  }
  return snapshot;
}

// Plays events and gives the consequences as words.
struct Play {
  explicit Play(const char* text = machine_text) {
    auto loaded = parse_machine(text, "m.json", WorldFacts::signature());
    if (!loaded) FAIL(loaded.error().text());
    pipeline.emplace(std::make_shared<const Machine>(std::move(*loaded)), nullptr, Perspective::avatar);
    state.emplace(pipeline->begin({Choice::unique, Random(1), {}, 0}, snapshot).after);
  }

  std::string point(double x, double confidence = 1) {
    InputEvent event;
    event.modality = Modality::gesture;
    event.name = "point";
    event.hand = "right";
    event.phase = "start";
    event.target_W = Vec3(x, 0, 0);
    event.confidence = confidence;
    return take(event);
  }
  std::string say(const std::string& words) {
    InputEvent event;
    event.text = words;
    return take(event);
  }

  std::string take(const InputEvent& event) { return told(pipeline->tick(*state, event, snapshot)); }
  std::string reports(ActReport::Status status) {
    return told(pipeline->reported(*state, {{latest, {}, status, 0, {ReasonCode::no_hold}}}, snapshot));
  }

  std::string told(Tick tick) {
    std::string happened;
    const auto add = [&](const std::string& what) { happened += (happened.empty() ? "" : "; ") + what; };
    for (const auto& one : tick.events) {
      if (const auto* change = std::get_if<BeliefChange>(&one))
        add(fmt::format("belief {} {}", change->name, change->value));
      if (const auto* gesture = std::get_if<GestureCommand>(&one))
        add(name_of(gesture->command.what) + " " + gesture->command.object);
      if (const auto* act = std::get_if<ActStep>(&one)) add(print(act->program)), latest = act->command->id;
      if (const auto* end = std::get_if<ActEnd>(&one)) add("act " + name_of(end->status) + " " + words_of(end->reason));
      if (const auto* unplanned = std::get_if<Unplanned>(&one)) add(unplanned->reason);
      if (const auto* step = std::get_if<StepEvent>(&one)) {
        if (const auto* said = std::get_if<Said>(step)) add("\"" + said->text + "\"");
        if (const auto* refused = std::get_if<RefusedInput>(step)) add(refused->reason);
      }
    }
    state = std::move(tick.after);
    return happened;
  }

  WorldSnapshot snapshot = world();
  std::optional<Pipeline> pipeline;
  std::optional<EngineState> state;
  int latest = 0;  // command
};

}  // namespace

TEST_CASE("a tick goes from what the human did to what the avatar says and does") {
  Play play;
  CHECK(play.point(0.28) == "belief point 0.5; \"This?\"; belief this 0.5; reach far_one");
  CHECK(play.say("Yes!") == "grasp(far_one)");
}

TEST_CASE("a step that does not end is undone, and the machine can say that an input was refused") {
  Play play(R"json({
    "machine": 1, "name": "m", "start": "Wait", "choice": "unique", "epsilon": "always", "slots": { "n": "num" },
    "transitions": [
      { "id": "round", "from": "Wait", "on": "speech round", "to": "Round", "push": { "n": "1" }, "do": [ { "say": "Off." } ] },
      { "id": "on", "from": "Round", "on": null, "to": "Round" },
      { "id": "lost", "from": "Wait", "on": "refused", "when": "said = 'round'", "to": "Wait", "do": [ { "say": "No." } ] },
      { "id": "well", "from": "Wait", "on": "speech well", "to": "Wait", "do": [ { "say": "Well." } ] } ] })json");
  CHECK(play.say("round") == "an ε-cycle that changes nothing: on; \"No.\"");
  CHECK(play.state->configuration.stack.depth() == 1);
  CHECK(play.say("other") == "no transition from Wait takes 'speech other'");
  CHECK(play.say("well") == "\"Well.\"");
}

TEST_CASE("an utterance equal to the last is not said again where the machine says so") {
  Play play;
  play.point(0.28);
  CHECK(play.point(0.12) == "belief point 1; reach near_one");
}

TEST_CASE("of several ways to say something the first is taken that is not what was said last") {
  Play play;
  CHECK(play.say("well") == "\"Well?\"");
  CHECK(play.say("well") == "\"So?\"");
  CHECK(play.say("well") == "\"Well?\"");
  CHECK(play.say("so") == "\"So?\"");
  CHECK(play.say("well") == "\"Well?\"");
}

TEST_CASE("a pipeline keeps nothing of a run: each run sees its own world, and a copy goes on with it") {
  Play play, other;
  other.snapshot.objects.pop_back();
  other.pipeline.emplace(*play.pipeline);
  other.state.emplace(other.pipeline->begin({Choice::unique, Random(1), {}, 0}, other.snapshot).after);
  play.point(0.28);
  CHECK(other.point(0.28) == "belief point 0.5; \"This?\"; belief this 0.5; reach near_one");
  play.pipeline.reset();
  play.pipeline.emplace(*other.pipeline);
  CHECK(play.say("no") == "belief point 0; no transition from Asked takes 'speech no'");
  CHECK(play.say("yes") == "grasp(far_one)");
  CHECK(other.say("yes") == "grasp(near_one)");
}

TEST_CASE("an answer lowers the belief in what was asked about") {
  Play play;
  play.point(0.28);
  CHECK(play.say("no") == "belief point 0; no transition from Asked takes 'speech no'");
}

TEST_CASE("an input of too little confidence is refused, and the beliefs stay") {
  Play play;
  CHECK(play.point(0.28, 0.3) == "confidence 0.3 is below the machine's minimum of 0.5");
}

TEST_CASE("how an act ended is an input where the machine knows it, and else only told") {
  Play play;
  play.point(0.28);
  play.say("yes");
  CHECK(play.reports(ActReport::Status::started) == "");
  CHECK(play.reports(ActReport::Status::blocked) ==
        "act blocked the fingers found no hold; \"Sorry, the fingers found no hold.\"");
  play.point(0.28);
  play.say("yes");
  CHECK(play.reports(ActReport::Status::dropped) == "act dropped the fingers found no hold");
}

TEST_CASE("an act that the body does not know is told, not fatal") {
  Play play;
  play.point(0.28);
  CHECK(play.say("fly") ==
        "act blocked fly(far_one) is no program that the body can perform; "
        "\"Sorry, fly(far_one) is no program that the body can perform.\"");
}
