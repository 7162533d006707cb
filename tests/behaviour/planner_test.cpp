#include "continua/behaviour/planner.h"

#include <cmath>

#include "continua/term/term_text.h"
#include "support/catch.h"

using namespace continua;

namespace {

const Signature& names() {
  static const Signature all = [] {
    Signature names = core_signature();
    const auto type = [](const char* text) { return *Type::parse(text); };
    for (const char* object : {"block1", "block2", "avatar"}) names.emplace(object, Type::entity());
    for (const char* program : {"grasp", "ungrasp", "lift", "shine", "turn", "flip"})
      names.emplace(program, type("e -> t"));
    for (const char* program : {"put", "slide", "push", "move"}) names.emplace(program, type("e -> loc -> t"));
    names.emplace("turn_by", type("e -> num -> t"));
    for (const char* program : {"stop", "retract"}) names.emplace(program, Type::truth());
    for (const char* place : {"left", "right", "in_front", "behind", "on", "in", "at", "beside", "touching", "under"})
      names.emplace(place, type("e -> loc"));
    names.emplace("between", type("e -> e -> loc"));
    names.emplace("reach", type("term -> t"));
    names.emplace("look_at", type("term -> t"));
    names.emplace("point", type("e -> loc -> t"));
    names.emplace("rHand", Type::entity());
    names.emplace("near", type("text -> loc -> loc"));
    return names;
  }();
  return all;
}

std::string planned(const std::string& text, bool gesture = false, Perspective perspective = Perspective::avatar) {
  const auto term = parse_term(text, names());
  if (!term) return term.error().text();
  const auto command = plan(*term, gesture, perspective);
  if (!command) return words_of(command.reason());
  const auto& goal = command->goal;
  std::string told = name_of(command->what) + " [" + command->object + "]";
  if (goal.relation) told += goal.perspective == Perspective::avatar ? " avatar's " : " human's ";
  if (goal.relation) told += name_of(*goal.relation);
  for (const auto& landmark : goal.landmarks) told += " " + landmark;
  if (!goal.relation) told += " " + print(Term::point(goal.p_WG.x(), goal.p_WG.y(), goal.p_WG.z()));
  if (command->turn_rad != 0) told += " by " + std::to_string(std::lround(command->turn_rad * 1000));
  return told + (command->name.empty() ? "" : " '" + command->name + "'");
}

}  // namespace

TEST_CASE("programs become commands of the body") {
  CHECK(planned("grasp(block1)") == "grasp [block1] <0, 0, 0>");
  CHECK(planned("put(block1, on(block2))") == "put [block1] avatar's on block2");
  CHECK(planned("move(block1, on(block2))") == "move [block1] avatar's on block2");
  CHECK(planned("push(block1, left(block2))") == "push [block1] avatar's left block2");
  CHECK(planned("turn(block1)") == "turn [block1] <0, 0, 0> by 1571");
  CHECK(planned("turn_by(block1, -180)") == "turn [block1] <0, 0, 0> by -3142");
  CHECK(planned("retract") == "retract [] <0, 0, 0>");
  CHECK(planned("stop") == "stop [] <0, 0, 0>");
  CHECK(planned("put(block1, <0.1, 0.2, 0>)") == "put [block1] <0.1, 0.2, 0>");
  CHECK(planned("put(block1, near('x', <0.1, 0.2, 0>))") == "put [block1] <0.1, 0.2, 0>");
  CHECK(planned("reach(block1)", true) == "reach [block1] <0, 0, 0>");
  CHECK(planned("reach(<0.1, 0, 0>)", true) == "reach [] <0.1, 0, 0>");
  CHECK(planned("point(rHand, <0.1, 0, 0>)", true) == "point [] <0.1, 0, 0>");
}

TEST_CASE("sides are the speaker's whose perspective it is") {
  CHECK(planned("slide(block1, left(block2))") == "slide [block1] avatar's left block2");
  CHECK(planned("slide(block1, left(block2))", false, Perspective::human) == "slide [block1] human's left block2");
}

TEST_CASE("place terms name a relation and its landmarks") {
  for (const char* place : {"left", "right", "in_front", "behind", "on", "in", "at", "beside", "touching", "under"})
    CHECK(planned("put(block1, " + std::string(place) + "(block2))") ==
          "put [block1] avatar's " + std::string(place) + " block2");
  CHECK(planned("put(block1, in_front(avatar))") == "put [block1] avatar's in_front avatar");
  CHECK(planned("slide(block1, left(block1))") == "slide [block1] avatar's left block1");
  CHECK(planned("put(block1, between(block2, avatar))") == "put [block1] avatar's between block2 avatar");
}

TEST_CASE("a gesture without a motion of its own is a signal, an act without a program is an error") {
  CHECK(planned("shine(block1)", true) == "signal [] <0, 0, 0> 'shine(block1)'");
  CHECK(planned("'HEAD_NOD'", true) == "signal [] <0, 0, 0> 'HEAD_NOD'");
  CHECK(planned("shine(block1)") == "shine(block1) is no program that the body can perform");
  CHECK(planned("flip(block1)") == "flip(block1) is no program that the body can perform");
  CHECK(planned("\\x. grasp(x)") == "\\x. grasp(x) is no program that the body can perform");
}
