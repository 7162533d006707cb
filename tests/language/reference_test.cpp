#include "continua/language/reference.h"

#include <algorithm>
#include <cstdlib>

#include "continua/term/substitution.h"
#include "support/small_talk.h"

#include <rapidcheck.h>

namespace continua {
namespace {

const Vec3 block_size(0.06, 0.06, 0.06);

// Seen by the human, left to right and near to far: a plate; a green block; a red block with a blue one behind it; a
// cup called like its kind with another red block right of it, a knife in it.
void set_table(SmallTalk& talk) {
  talk.world.objects = {thing("plate", "plate", "", {0.2, 0.2, 0.02}, -0.4, 0),
                        thing("green1", "block", "green", block_size, -0.2, 0),
                        thing("red1", "block", "red", block_size, 0, 0),
                        thing("blue1", "block", "blue", block_size, 0, 0.15),
                        thing("cup", "cup", "white", {0.08, 0.08, 0.1}, 0.2, 0),
                        thing("red2", "block", "red", block_size, 0.35, 0.01),
                        thing("knife", "knife", "", {0.01, 0.02, 0.2}, 0.2, 0, 0.01)};
  talk.world.objects[4].interior = Box{{-0.03, -0.03, -0.04}, {0.03, 0.03, 0.05}};
}

std::string reason(const Reference& reference, const std::string& object) {
  for (const auto& each : reference.ruled_out)
    if (each.object == object) return each.reason;
  return "";
}

std::string weights_of(const Reference& reference) {
  std::string text;
  for (const auto& each : reference.referents) text += each.object + " " + std::to_string(each.weight) + " ";
  return text;
}

}  // namespace

TEST_CASE("a noun phrase means the objects of which its condition is true") {
  SmallTalk talk;
  set_table(talk);
  talk.context.focus = {"red2", "plate"};
  talk.context.topics = {talk.read("\\x. block(x)")};
  talk.context.pointed_W = Vec3(-0.21, 0.02, 0);
  const auto [phrase, expected] = GENERATE(table<std::string, std::string>({
      {"the(\\x. plate(x))", "plate"},
      {"the(plate)", "plate"},
      {"the(\\x. cup(x))", "cup"},
      {"the(\\x. green(x) and plate(x))", ""},
      {"the(\\x. red(x) and block(x))", "red2 red1"},  // the one in focus first
      {"a(\\x. block(x) and blue(x))", "blue1"},
      {"the(\\x. blue(x) and one(x))", "blue1"},
      {"the(\\x. other(x) and red(x) and block(x))", "red1"},
      {"another(\\x. red(x) and block(x))", "red1"},
      {"all(\\x. red(x) and block(x))", "red2 red1"},
      {"the(\\x. block(x) and located(x, right(the(\\y. plate(y)))))", "red2 green1 red1"},
      {"the(\\x. red(x) and located(x, right(the(\\y. cup(y)))))", "red2"},
      {"the(\\x. red(x) and located(x, left(the(\\y. red(y)))))", "red1"},  // of one of the red ones, not of itself
      {"the(\\x. red(x) and located(x, left(the(\\y. other(y) and red(y)))))", "red1"},
      {"the(\\x. red(x) and located(x, left(another(\\y. block(y)))))", "red1"},
      {"the(\\x. block(x) and located(x, behind(the(\\y. block(y) and located(y, right(the(\\z. green(z))))))))",
       "blue1"},
      {"the(\\x. red(x) and located(x, between(the(\\y. green(y)), the(\\y. cup(y)))))", "red1"},
      {"the(\\x. red(x) and located(x, between(a(\\y. block(y)), a(\\y. red(y)))))", "red1"},
      {"the(\\x. located(x, in(the(\\y. cup(y)))))", "knife"},
      {"the(\\x. block(x) and located(x, left(it)))", "green1 red1"},
      {"the(\\x. block(x) and located(x, there))", "green1"},
      {"the(\\x. block(x) and located(x, left(you)) and located(x, in_front(you)))", "red2"},
      {"the(\\x. block(x) and located(x, right(me)))", "red2"},
      {"the(\\x. leftmost(\\y. block(y))(x))", "green1"},
      {"the(\\x. leftmost(\\y. block(y) and located(y, right(the(\\z. red(z)))))(x))", "red2"},
      {"the(\\x. not red(x) and (cup(x) or knife(x)))", "cup knife"},
      {"that(\\x. block(x))", "green1"},
      {"that(\\x. red(x))", "red2 red1"},  // far from the place pointed at: words decide
      {"the(\\x. block(x) and located(x, behind(me)))", ""},
      {"the(\\x. attribute(x, 'color') = attribute(a(\\y. blue(y)), 'color'))", ""},  // none but itself
      {"the(\\x. block(x) and x = the(\\y. blue(y)))", "blue1"},
      {"the(\\x. x = the(\\y. blue(y)) or x = the(\\y. plate(y)))", "plate blue1"},
      {"the(\\x. null)", ""},
      {"the(\\x. true)", "red2 plate green1 red1 blue1 cup knife"},
  }));
  INFO(phrase);
  CHECK(names_of(talk.refer(phrase)) == expected);
}

TEST_CASE("sides are taken in a rough sense, then in a loose one, where nothing fits") {
  SmallTalk talk;
  set_table(talk);
  const auto [phrase, expected, sides] = GENERATE(table<std::string, std::string, Sides>({
      {"the(\\x. block(x) and located(x, left(the(\\y. red(y)))))", "green1 red1", Sides::exact},
      {"the(\\x. block(x) and located(x, left(the(\\y. blue(y)))))", "green1", Sides::rough},
      {"the(\\x. cup(x) and located(x, in_front(the(\\y. blue(y)))))", "cup", Sides::loose},
      {"the(\\x. cup(x) and located(x, behind(the(\\y. blue(y)))))", "", Sides::exact},
      {"the(\\x. red(x) and plate(x))", "", Sides::exact},
  }));
  INFO(phrase);
  const auto reference = talk.refer(phrase);
  CHECK(names_of(reference) == expected);
  CHECK(reference.sides == sides);
}

TEST_CASE("what answers a question is compared with what was asked about") {
  SmallTalk talk;
  set_table(talk);
  const std::string leftmost = "the(\\x. leftmost(\\y. block(y))(x))";
  CHECK(names_of(talk.refer(leftmost)) == "green1");
  talk.context.among = {"red1", "red2"};
  CHECK(names_of(talk.refer(leftmost)) == "red1");
  // The inner phrase ranges over the whole scene: neither of the two has the color of the leftmost block.
  CHECK(names_of(talk.refer(
            "the(\\x. attribute(x, 'color') = attribute(the(\\y. leftmost(\\z. block(z))(y)), 'color'))")) == "");
}

TEST_CASE("what is ruled out has its reason, in the scene's order") {
  SmallTalk talk;
  set_table(talk);
  const auto reference =
      talk.refer("the(\\x. block(x) and red(x) and located(x, left(the(\\y. white(y) and cup(y)))))");
  CHECK(names_of(reference) == "red1");
  std::string order;
  for (const auto& each : reference.ruled_out) order += each.object + " ";
  CHECK(order == "plate green1 blue1 cup red2 knife ");
  CHECK(reason(reference, "plate") == "not block(plate)");
  CHECK(reason(reference, "green1") == "not red(green1)");
  CHECK(reason(reference, "red2") == "not located(red2, left(the(\\y. white(y) and cup(y))))");
  talk.context.among = {"red2", "cup"};
  talk.context.focus = {"red2"};
  CHECK(reason(talk.refer("another(\\x. red(x))"), "red2") == "in focus");
  CHECK(reason(talk.refer("another(\\x. red(x))"), "red1") == "not asked about");
  CHECK(names_of(talk.refer("the(\\x. red(x))")) == "red2");
  CHECK(reason(talk.refer("the(\\x. other(x))"), "red2") == "not other(red2)");
}

TEST_CASE("pointing counts for deictic phrases only") {
  SmallTalk talk;
  set_table(talk);
  talk.context.pointed_W = Vec3(0.01, 0.02, 0);
  CHECK(names_of(talk.refer("that(\\x. block(x))")) == "red1");
  CHECK(reason(talk.refer("that(\\x. block(x))"), "blue1") == "not pointed at");
  CHECK(names_of(talk.refer("the(\\x. block(x))")) == "green1 red1 blue1 red2");
  CHECK(names_of(talk.refer("the(\\x. block(x) and located(x, behind(that(\\y. block(y)))))")) == "blue1");
  CHECK(names_of(talk.refer("the(\\x. block(x) and located(x, right(that(\\y. block(y)))))")) == "red2");
  // The phrase around takes the pointing.
  CHECK(names_of(talk.refer("that(\\x. block(x) and located(x, right(that(\\y. block(y)))))")) == "red1");
  talk.context.pointed_W = Vec3(0, 0.075, 0);
  CHECK(weights_of(talk.refer("those(\\x. block(x))")) == "red1 0.500000 blue1 0.500000 ");
  talk.context.focus = {"blue1"};
  CHECK(weights_of(talk.refer("that(\\x. block(x))")) == "blue1 0.500000 red1 0.500000 ");
  // Far from all that the words mean, pointing says nothing.
  talk.context.pointed_W = Vec3(-0.4, 0, 0);
  CHECK(weights_of(talk.refer("that(\\x. red(x))")) == "red1 0.500000 red2 0.500000 ");
}

TEST_CASE("pointing alone means what is near") {
  SmallTalk talk;
  set_table(talk);
  CHECK(names_of(refer_to_pointed(talk.context)).empty());
  talk.context.pointed_W = Vec3(0.2, -0.2, 0);
  CHECK(names_of(refer_to_pointed(talk.context)).empty());
  CHECK(refer_to_pointed(talk.context).ruled_out.size() == 7);
  talk.context.pointed_W = Vec3(0.01, 0.05, 0);
  CHECK(names_of(refer_to_pointed(talk.context)) == "red1");
  talk.context.pointed_W = Vec3(0.01, 0.075, 0);
  CHECK(names_of(refer_to_pointed(talk.context)) == "red1 blue1");
  // Alone it would be too far off, but it is about as likely.
  talk.context.pointed_W = Vec3(0, 0.0715, 0);
  CHECK(names_of(refer_to_pointed(talk.context)) == "red1 blue1");
  talk.context.pointed_W = Vec3(-0.33, 0.03, 0);
  CHECK(names_of(refer_to_pointed(talk.context)) == "plate");
  talk.context.among = {"plate", "cup"};
  CHECK(names_of(refer_to_pointed(talk.context)) == "plate");
}

TEST_CASE("pointing far from the options means what is near, not an option") {
  SmallTalk talk;
  set_table(talk);
  talk.context.pointed_W = Vec3(-0.33, 0.03, 0);
  talk.context.among = {"cup"};
  CHECK(names_of(refer_to_pointed(talk.context)) == "plate");
}

TEST_CASE("deep and endless conditions end") {
  SmallTalk talk;
  set_table(talk);
  const Term level = talk.read(
      "\\f: e -> t. \\x. block(x) and (located(x, right(a(f))) or located(x, left(a(\\y. other(y) and block(y)))))");
  const auto nested = [&](int depth) {
    Term condition = talk.read("block");
    for (int i = 0; i < depth; ++i) condition = instantiate(level.body(), condition);
    return talk.refer(Term::apply(talk.read("the"), condition));
  };
  CHECK(names_of(nested(6)) == "green1 red1 red2");
  CHECK(nested(300).ruled_out.size() == 7);
  std::string wide = "located(x, right(a(block)))", many;
  for (int i = 0; i < 6; ++i) wide = "(" + wide + " = located(x, between(a(block), a(\\y. true))))";
  talk.refer("the(\\x. " + wide + ")");
  for (int i = 0; i < 90; ++i) many += "block(x) and ";
  CHECK(names_of(talk.refer("the(\\x. " + many + "red(x))")) == "red1 red2");
  const Term loop = talk.read("\\x: term. x(x)");
  CHECK(names_of(talk.refer(Term::apply(talk.read("the"), Term::apply(loop, loop)))).empty());
}

}  // namespace continua
