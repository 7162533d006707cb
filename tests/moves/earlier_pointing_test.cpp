// Which words take which of the pointings before them.
#include "continua/moves/earlier_pointing.h"

#include <fmt/format.h>

#include "support/catch.h"

using namespace continua;

namespace {

constexpr bool needs = true, place = true;

Vec3 at(double x) { return {x, 0, 0}; }

Demonstrative word(std::size_t begin, bool needing, bool for_place = false) {
  return {{begin, begin + 1}, needing, for_place};
}

// "0:1 2:3": the word at 0 takes the pointing at x = 1, the word at 2 that at x = 3.
std::string taken(const std::vector<Demonstrative>& words, const EarlierPointings& earlier) {
  auto showings = taken_by(words, earlier);
  std::sort(showings.begin(), showings.end(),
            [](const Showing& a, const Showing& b) { return a.words.begin < b.words.begin; });
  std::string all;
  for (const auto& each : showings) {
    all += fmt::format("{}{}:{}", all.empty() ? "" : " ", each.words.begin, each.place_W.x());
    CHECK_FALSE(each.is_gesture);
  }
  return all;
}

}  // namespace

TEST_CASE("words for a thing take the half of the things, words for a place the half of the place") {
  CHECK(taken({word(1, needs)}, {{at(1)}, {at(1)}}) == "1:1");
  CHECK(taken({word(1, needs)}, {{}, {at(1)}}).empty());
  CHECK(taken({word(2, needs, place)}, {{at(1)}, {at(1)}}) == "2:1");
  CHECK(taken({word(2, needs, place)}, {{at(1)}, {}}).empty());
  CHECK(taken({}, {{at(1)}, {at(1)}}).empty());
}

TEST_CASE("each pointing goes with one word, and later ones with later words") {
  const EarlierPointings two = {{at(2), at(1)}, {at(2), at(1)}};
  CHECK(taken({word(1, needs), word(2, needs, place)}, two) == "1:1 2:2");
  CHECK(taken({word(1, needs), word(3, needs)}, two) == "1:1 3:2");
  CHECK(taken({word(1, needs), word(2, needs, place)}, {{at(1)}, {at(2), at(1)}}) == "1:1 2:2");
}

TEST_CASE("with fewer pointings than words the thing is shown and the place is open") {
  CHECK(taken({word(1, needs), word(2, needs, place)}, {{at(1)}, {at(1)}}) == "1:1");
  CHECK(taken({word(1, needs), word(2, needs, place)}, {{}, {at(1)}}) == "2:1");
}

TEST_CASE("words that need no pointing share the latest one at things") {
  CHECK(taken({word(1, !needs), word(4, !needs)}, {{at(2), at(1)}, {}}) == "1:2 4:2");
  CHECK(taken({word(1, !needs)}, {{}, {at(1)}}).empty());
}

TEST_CASE("these are all that were shown") {
  Demonstrative more = word(1, !needs);
  more.more = true;
  CHECK(taken({more, more, word(1, needs)}, {{at(2), at(1)}, {}}) == "1:2 1:1");
  CHECK(taken({more, more, word(1, needs)}, {{at(1)}, {}}) == "1:1");
  CHECK(taken({more, word(1, needs), word(3, needs, place)}, {{at(2), at(1)}, {at(3), at(2), at(1)}}) == "1:2 1:1 3:3");
}
