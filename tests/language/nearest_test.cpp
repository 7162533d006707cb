// The clearly nearest of several things.
#include "continua/language/nearest.h"

#include "support/catch.h"
#include "support/small_talk.h"

using namespace continua;

namespace {

// A plate in the middle of the table, and two blocks left of it at these distances.
std::string meant(const std::string& condition, double first_m, double second_m) {
  SmallTalk talk;
  const Vec3 size(0.06, 0.06, 0.06);
  talk.world.objects = {thing("plate", "plate", "", {0.06, 0.06, 0.02}, 0, 0),
                        thing("far", "block", "red", size, -second_m, 0),
                        thing("near", "block", "green", size, -first_m, 0)};
  const Term phrase = talk.read("the(" + condition + ")");
  std::string names;
  const auto all = nearest_to_landmark(talk.refer(phrase), phrase.argument(), talk.context, talk.meanings());
  for (const auto& each : all.referents) names += (names.empty() ? "" : " ") + each.object;
  return names;
}

}  // namespace

TEST_CASE("of several things that are near another the clearly nearest is meant") {
  const std::string near = "\\x. block(x) and located(x, near(the(\\y. plate(y))))";
  CHECK(meant(near, 0.1, 0.15) == "near");
  CHECK(meant(near, 0.11, 0.15) == "near");
  CHECK(meant(near, 0.13, 0.15) == "far near");
}

TEST_CASE("without one landmark, or on its side, the nearest is no likelier") {
  CHECK(meant("\\x. block(x)", 0.1, 0.3) == "far near");
  CHECK(meant("\\x. block(x) and located(x, left(the(\\y. plate(y)))) and located(x, left(the(\\z. plate(z))))", 0.1,
              0.3) == "far near");
}
