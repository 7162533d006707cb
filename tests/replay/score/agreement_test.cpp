// Agreement of deeds, as tables: observed, came out, level.
#include "continua/replay/score/agreement.h"

#include "support/catch.h"

using namespace continua;

namespace {

using Moves = std::vector<AvatarMove>;

AvatarMove say(const std::string& words) { return {"speech", words}; }
AvatarMove act(const std::string& term) { return {"action", term}; }
AvatarMove gesture(const std::string& term) { return {"gesture", term}; }

const Blanks blanks{{"block1", "block2", "red", "black", "light_blue", "cup_1"}};

std::string level(const Moves& observed, const Moves& produced) {
  return name_of(agreement(observed, produced, blanks));
}

std::string level_of_acts(const std::string& observed, const std::string& produced) {
  return level({act(observed)}, {act(produced)});
}

std::string nested(std::size_t depth, const std::string& core) {
  std::string term;
  for (std::size_t i = 0; i < depth; ++i) term += "f(";
  return term + core + std::string(depth, ')');
}

}  // namespace

TEST_CASE("the same moves agree exactly, silence with silence") {
  CHECK(level({}, {}) == "exact");
  CHECK(level({say("OK."), act("grasp(block1)")}, {say("OK."), act("grasp(block1)")}) == "exact");
  CHECK(level({act("put(block1,on(block2))")}, {act("put( block1, on(block2) )")}) == "exact");
  CHECK(level({say("OK.")}, {}) == "none");
  CHECK(level({}, {say("OK.")}) == "none");
  CHECK(level({say("Hello.")}, {say("hello.")}) == "none");
}

TEST_CASE("order and channels count") {
  const auto ok = say("OK."), grasp = act("grasp(block1)"), look = gesture("look_at(block1)");
  CHECK(level({ok, grasp}, {grasp, ok}) == "none");
  CHECK(level({ok, look, grasp}, {ok, grasp, look}) == "template");
  CHECK(level({ok, grasp}, {ok, grasp, grasp}) == "none");
  CHECK(level({ok, grasp}, {ok}) == "none");
  CHECK(level({gesture("grasp(block1)")}, {grasp}) == "none");
  CHECK(level({say("grasp(block1)")}, {grasp}) == "none");
}

TEST_CASE("coordinates may differ by two millimetres") {
  const auto at = [](const char* x) { return std::string("put(block1, <") + x + ", 0, 0.02>)"; };
  CHECK(level_of_acts(at("0.1"), at("0.1")) == "exact");
  CHECK(level_of_acts(at("0.1"), at("0.1000")) == "exact");
  CHECK(level_of_acts(at("-0"), at("0")) == "exact");
  CHECK(level_of_acts(at("0.1"), at("0.102")) == "exact");
  CHECK(level_of_acts(at("0.1"), at("0.098")) == "exact");
  CHECK(level_of_acts(at("0.1"), at("0.1021")) == "template");
  CHECK(level_of_acts(at("0.1"), at("1e99")) == "template");
  CHECK(level_of_acts(at("0.1"), at("1e999")) == "none");
  CHECK(level_of_acts("put(block1, <0.1, 0>)", "put(block1, <0.1, 0, 0>)") == "none");
  CHECK(level({gesture("point(<0.1, 0, 0>)")}, {gesture("point(<0.101, 0, 0>)")}) == "exact");
  CHECK(level({gesture("point(<0.1, 0, 0>)")}, {gesture("point(<0.2, 0, 0>)")}) == "none");
  CHECK(level({say("<0.1, 0>")}, {say("<0.101, 0>")}) == "none");
}

TEST_CASE("a place that is only described may be any place") {
  const std::string there = "put(block1, <0.1, 0, 0>)", described = "put(block1, part('front', 'left', <0.3, 0, 0>))";
  CHECK(level_of_acts(there, described) == "lax");
  CHECK(level_of_acts(described, described) == "exact");
  CHECK(level_of_acts(there, "put(block1, <0.3, 0, 0>)") == "template");
  CHECK(level_of_acts(there, "put(block2, part('front', 'left', <0.3, 0, 0>))") == "template");
  CHECK(level_of_acts(described, there) == "template");
  CHECK(level_of_acts(there, "put(block1, on(block2))") == "none");
  CHECK(level({say("OK."), act(there)}, {say("OK."), act(described)}) == "lax");
  CHECK(level({say("OK."), act(there)}, {say("Okay."), act(described)}) == "none");
}

TEST_CASE("a template leaves out names, attributes, places and gestures, and no other words") {
  CHECK(level({say("The red block?")}, {say("The black block?")}) == "template");
  CHECK(level({say("RED?")}, {say("Block1?")}) == "template");
  CHECK(level({say("The red block?")}, {say("The big block?")}) == "none");
  CHECK(level({say("The red block?")}, {say("A red block?")}) == "none");
  CHECK(level({say("The reddish block?")}, {say("The blackish block?")}) == "none");
  CHECK(level_of_acts("grasp(block1)", "grasp(block2)") == "template");
  CHECK(level_of_acts("grasp(block1)", "grasp(block3)") == "none");
  CHECK(level_of_acts("grasp(block1)", "lift(block1)") == "none");
  CHECK(level_of_acts("paint(block1, 'red')", "paint(block2, 'black')") == "template");
  CHECK(level_of_acts("paint(block1, 'red')", "paint(block1, 'green')") == "none");
  CHECK(level({say("OK."), gesture("reach(block1)")}, {say("OK.")}) == "template");
  CHECK(level({gesture("reach(block1)")}, {gesture("reach(block2)")}) == "none");
  CHECK(level({gesture("reach(block1)")}, {}) == "none");
}

TEST_CASE("templates can be read") {
  CHECK(template_of(say("Should I put the red block on the black block?"), blanks) ==
        "Should I put the _ block on the _ block?");
  CHECK(template_of(act("put(block1,on(block2))"), blanks) == "put(_, on(_))");
  CHECK(template_of(act("put(block1, <0.1, 0, 0>)"), blanks) == "put(_, _)");
  CHECK(template_of(act("put(cup_1, part('front', <0.1, 0, 0>))"), blanks) == "put(_, _)");
  CHECK(template_of(act("push([block1, 'the red one', []], <0, 0, 0>)"), blanks) == "push([_, 'the _ one', []], _)");
  CHECK(template_of(act("stop"), blanks) == "stop");
  CHECK(template_of({say("OK."), gesture("reach(block1)"), act("grasp(block1)")}, blanks) ==
        std::vector<std::string>{"say OK.", "grasp(_)"});
}

TEST_CASE("what is no term is compared as it stands") {
  for (const std::string text : {"G push right high", "put(block1", "put)block1(", "put(block1,)", "<0.1, 0", "'red",
                                 "", ",", "put(block1) again", "f(]", "  "}) {
    CAPTURE(text);
    CHECK(level_of_acts(text, text) == "exact");
    CHECK(level_of_acts(text, text + "?") == "none");
    CHECK(level_of_acts("grasp(block1)", text) == "none");
  }
  CHECK(level_of_acts("push block1 right", "push block2 right") == "template");
  CHECK(level_of_acts("put(block1", "put(block2") == "template");
}

TEST_CASE("terms may be deep, but only so deep") {
  CHECK(level_of_acts(nested(50, "<0.1, 0, 0>"), nested(50, "<0.101, 0, 0>")) == "exact");
  CHECK(level_of_acts(nested(51, "<0.1, 0, 0>"), nested(50, "<0.1, 0, 0>")) == "template");
  CHECK(level_of_acts(nested(50, "x"), nested(51, "x")) == "none");
  CHECK(level_of_acts(nested(100000, "<0.1, 0, 0>"), nested(100000, "<0.101, 0, 0>")) == "none");
  CHECK(level_of_acts(nested(100000, "x"), nested(100000, "x")) == "exact");
}
