#include "continua/perception/shown_with.h"

#include "perception/talk.h"
#include "support/catch.h"

using namespace continua;

namespace {

const FusionWindow patient{2, 1, 0, 1}, hasty{2, 1, 0, 0};

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

Percept words(double t_s) { return speech(1, t_s, {{"push", t_s, t_s}, {"it", t_s, t_s}}, false); }

}  // namespace

TEST_CASE("words without a told end and a gesture wait for one another") {
  CHECK(heard_and_seen({words(1), gesture(2, 1.3, "push")}) == "1.40 push it; 1.40 push");
  CHECK(heard_and_seen({gesture(2, 1, "push"), words(1.3)}) == "1.70 push; 1.70 push it");
  CHECK(heard_and_seen({words(1), gesture(2, 1.5, "push")}) == "1.40 push it; 1.90 push");
  CHECK(heard_and_seen({words(1), gesture(2, 1.3, "push")}, hasty) == "1.00 push it; 1.30 push");
}

TEST_CASE("words with a told end wait for nothing, and an event that is over at once neither") {
  CHECK(heard_and_seen({speech(1, 1, {{"stop", 1, 1.2}})}) == "1.20 stop");
  CHECK(heard_and_seen({gesture(2, 1, "stop", 1)}) == "1.00 stop");
  CHECK(!is_shown_with(gesture(2, 1, "stop", 1), words(1), patient));
  CHECK(is_shown_with(gesture(2, 1, "push"), words(1), patient));
}

TEST_CASE("a pointing that no words take comes with words that ask for none") {
  CHECK(heard_and_seen({words(1), gesture(2, 1.2, "point")}) == "1.40 push it; 1.40 point");
}
