// A conversation without replay/: laws of time, and a guest's view.
#include "continua/continua.h"

#include <map>

#include "continua/term/term_text.h"
#include "support/catch.h"

using namespace continua;

namespace {

WorldSnapshot two_blocks() {
  WorldSnapshot world;
  world.table = {{-0.4, -0.4, 0}, {0.4, 0.4, 0}};
  for (const auto& [name, color, y] : {std::tuple("b1", "red", 0.15), std::tuple("b2", "blue", -0.15)}) {
    ObjectState block;
    block.name = name;
    block.attributes = {{"type", "block"}, {"color", color}};
    block.half_extents_m = {0.03, 0.03, 0.03};
    block.p_WO = {0, y, 0.03};
    world.objects.push_back(block);
  }
  return world;
}

struct Play {
  Play() : body(two_blocks()), conversation(parts(), body) { note(conversation.begin()); }

  static const EngineParts& parts() {
    static const auto parts = load_engine_parts("interaction", data_paths_of(CONTINUA_DATA_DIR).value()).value();
    return parts;
  }

  void hear(const std::string& words) {
    InputEvent event;
    event.t = conversation.now();
    event.text = words;
    note(conversation.hear(event));
  }
  void see(const std::string& gesture, std::optional<Vec3> target_W = {}) {
    InputEvent event;
    event.modality = Modality::gesture;
    event.t = conversation.now();
    event.name = gesture;
    event.target_W = target_W;
    note(conversation.hear(event));
  }
  void advance(double seconds) { note(conversation.advance(SimTime::from_seconds(seconds))); }

  void note(const std::vector<Happening>& happenings) {
    for (const auto& happening : happenings)
      if (const auto* thought = std::get_if<Thought>(&happening))
        for (const auto& event : thought->events) {
          if (const auto* step = std::get_if<StepEvent>(&event))
            if (const auto* said = std::get_if<Said>(step)) told += "says " + said->text + "\n";
          if (const auto* end = std::get_if<ActEnd>(&event)) told += "did " + print(end->act.program) + "\n";
        }
  }

  KinematicBody body;
  Conversation conversation;
  std::string told;
};

}  // namespace

TEST_CASE("a command in one utterance is done by the body and moves the object") {
  Play play;
  play.hear("put the red block on the blue block");
  play.advance(20);
  CHECK(play.told == "says Okay.\ndid put(b1, on(b2))\n");
  const auto world = play.body.snapshot();
  CHECK(world.find("b1")->p_WO.z() > world.find("b2")->p_WO.z());
}

TEST_CASE("a call-off that is complete when an act begins stops it before anything has changed") {
  Play play;
  play.hear("take that block");
  play.advance(0.2);
  play.see("point", Vec3(0, 0.15, 0));
  play.advance(0.8);
  play.see("stop");
  play.advance(10);
  CHECK(play.told == "says Okay, the red block.\nsays Okay, never mind.\ndid grasp(b1)\ndid stop\n");
  CHECK(play.body.snapshot().held.empty());
}

TEST_CASE("a gesture that contradicts words just after them stops their act before it has changed anything") {
  for (const double later_s : {0.1, 0.3, 0.39}) {
    CAPTURE(later_s);
    Play play;
    play.hear("take the red block");
    play.advance(later_s);
    play.see("point", Vec3(0, -0.15, 0));
    play.advance(10);
    CHECK(play.told ==
          "says Okay.\nsays You say the red block and point at the blue block.\nsays Should I take the red block?\n"
          "did grasp(b1)\ndid stop\n");
    CHECK(play.body.snapshot().held.empty());
  }
}

TEST_CASE("an act does not wait for gestures without end") {
  Play play;
  play.hear("take the red block");
  for (int i = 1; i <= 40; ++i) {
    play.advance(0.1 * i);
    play.see("point", Vec3(0, 0.15, 0));
  }
  CHECK(play.body.snapshot().held == "b1");
}

TEST_CASE("a continuation waits in the state until the human says the rest") {
  Play play;
  play.hear("put it there");
  play.advance(5);
  const auto depth = play.conversation.state().configuration.stack.depth();
  play.hear("never mind");
  play.advance(10);
  CHECK(play.conversation.state().configuration.stack.depth() < depth);
  CHECK(play.body.at_rest());
  CHECK(play.told.find("did ") == std::string::npos);
}

TEST_CASE("cutting time into pieces makes no difference") {
  Play whole, cut;
  for (auto* play : {&whole, &cut}) play->hear("take the red block");
  whole.advance(10);
  for (int i = 1; i <= 100; ++i) cut.advance(0.1 * i);
  CHECK(whole.told == cut.told);
  CHECK(whole.conversation.now() == cut.conversation.now());
}

TEST_CASE("time never goes back, and waiting for nothing changes nothing") {
  Play play;
  play.advance(3);
  const auto told = play.told;
  play.advance(1);
  CHECK(play.conversation.now() == SimTime::from_seconds(3));
  CHECK(play.told == told);
}

TEST_CASE("knowledge that is not there is an error with a place") {
  CHECK_FALSE(data_paths_of("/nowhere").ok());
  const auto data = data_paths_of(CONTINUA_DATA_DIR).value();
  const auto parts = load_engine_parts("interactoin", data);
  REQUIRE_FALSE(parts.ok());
  CHECK(parts.error().text().find("interaction") != std::string::npos);
}
