#include "continua/perception/shown_with.h"

#include "perception/talk.h"
#include "support/catch.h"

using namespace continua;

namespace {

const FusionWindow patient{2, 1, 0, 1}, hasty{2, 1, 0, 0}, expectant{2, 1, 0, 1, 0.4};

std::string heard_and_seen(std::vector<Percept> percepts, const FusionWindow& window = patient) {
  Fusion fusion(window, {{-1, -1, -1}, {1, 1, 1}});
  std::vector<Ensemble> all;
  const auto release = [&](SimTime now) {
    for (auto& each : fusion.release(now)) all.push_back(std::move(each));
  };
  for (auto& percept : percepts) {
    const SimTime t = percept.event.t;
    while (fusion.due() && *fusion.due() < t) release(*fusion.due());
    fusion.receive(std::move(percept), t);
    release(t);
  }
  while (const auto due = fusion.due()) release(*due);
  return brief(all);
}

Percept words(double t_s, double until_s) {
  Percept said = speech(1, t_s, {{"push", t_s, t_s}, {"it", t_s, t_s}}, false);
  said.event.until = SimTime::from_seconds(until_s);
  return said;
}

}  // namespace

TEST_CASE("a gesture that begins before the told end of words comes with them") {
  CHECK(heard_and_seen({words(1, 2), gesture(2, 1.3, "push")}) == "2.00 push it; 2.00 push");
  CHECK(heard_and_seen({words(1, 1), gesture(2, 1.3, "push")}) == "1.00 push it; 1.30 push");
}

TEST_CASE("a gesture waits for words that begin soon after it, or while it lasts") {
  CHECK(heard_and_seen({gesture(1, 1, "push"), words(1.3, 2)}, expectant) == "2.00 push it; 2.00 push");
  CHECK(heard_and_seen({gesture(1, 1, "push"), words(1.3, 1.3)}, expectant) == "1.30 push it; 1.30 push");
  CHECK(heard_and_seen({gesture(1, 1, "push"), words(1.5, 2)}, expectant) == "1.40 push; 2.00 push it");
  CHECK(heard_and_seen({gesture(1, 1, "push", 1.8), words(1.7, 2)}, expectant) == "2.00 push it; 2.00 push");
  CHECK(heard_and_seen({gesture(1, 1, "push")}, expectant) == "1.40 push");
}

TEST_CASE("words, and gestures made by themselves, never wait for a counterpart") {
  CHECK(heard_and_seen({words(1, 1), gesture(2, 1.2, "push")}, expectant) == "1.00 push it; 1.60 push");
  CHECK(heard_and_seen({gesture(1, 1, "halt", 1), words(1.3, 2)}, expectant) == "1.00 halt; 2.00 push it");
}

TEST_CASE("an event that is over at once is not shown with words") {
  CHECK(!is_shown_with(gesture(2, 1, "stop", 1), words(1, 2), patient));
  CHECK(!is_shown_with(gesture(2, 1, "push"), words(1, 2), hasty));
  CHECK(is_shown_with(gesture(2, 1, "push"), words(1, 1), patient));
  CHECK(!is_shown_with(gesture(2, 0.9, "push"), words(1, 1), patient));
}

TEST_CASE("a pointing that no words take comes with words that ask for none") {
  CHECK(heard_and_seen({words(1, 2), gesture(2, 1.2, "point")}) == "2.00 push it; 2.00 point");
}
