// The input to which each deed belongs.
#include "continua/replay/score/episodes.h"

#include "support/catch.h"

using namespace continua;

namespace {

SimTime at(double seconds) { return SimTime::from_seconds(seconds); }

Episode words(double t) { return {at(t), 1, 2, "speech yes", false, {}, {}, {}}; }
Episode sample(double t) { return {at(t), 3, 4, "pointing", true, {}, {}, {}}; }
AvatarMove say(const std::string& text) { return {"speech", text}; }

// "yes|OK./Okay." is an episode in which "OK." was observed and "Okay." came out.
std::string told(Episodes& episodes) {
  std::string all;
  for (const auto& episode : episodes.take({})) {
    all += (all.empty() ? "" : "; ") + episode.symbol + "|";
    for (const auto& move : episode.observed) all += move.content;
    all += "/";
    for (const auto& move : episode.produced) all += move.content;
  }
  return all;
}

}  // namespace

TEST_CASE("moves belong to the input that came last") {
  Episodes episodes(true, true);
  CHECK(episodes.last() == nullptr);
  episodes.begin(words(1));
  episodes.observed(say("a"), at(1));
  episodes.produced(say("b"), at(2));
  episodes.begin(words(3));
  REQUIRE(episodes.last());
  CHECK(episodes.last()->t == at(3));
  episodes.produced(say("c"), at(3));
  episodes.observed(say("d"), at(3.7));
  CHECK(told(episodes) == "speech yes|a/b; speech yes|d/c");
}

TEST_CASE("of inputs of one instant the last counts") {
  Episodes episodes(true, true);
  episodes.begin(words(1));
  episodes.produced(say("a"), at(1));
  episodes.begin(words(1));
  episodes.produced(say("b"), at(1));
  CHECK(told(episodes) == "speech yes|/a; speech yes|/b");
}

TEST_CASE("moves belong to a pointing sample only if they are of its instant") {
  Episodes episodes(true, true);
  episodes.begin(words(1));
  episodes.begin(sample(1.5));
  episodes.observed(say("a"), at(1.5));
  episodes.begin(sample(1.6));
  episodes.observed(say("b"), at(1.7));
  episodes.produced(say("c"), at(1.7));
  CHECK(told(episodes) == "speech yes|b/c; pointing|a/; pointing|/");
}

TEST_CASE("of those who do not answer at once, samples have no moves") {
  Episodes episodes(false, true);
  episodes.begin(words(1));
  episodes.begin(sample(1.5));
  episodes.produced(say("a"), at(1.5));
  episodes.observed(say("b"), at(1.5));
  episodes.begin(words(2));
  episodes.observed(say("c"), at(2));
  CHECK(told(episodes) == "speech yes|b/a; pointing|/; speech yes|c/");
}

TEST_CASE("before any other input moves belong to the sample that came last") {
  Episodes episodes(true, true);
  episodes.begin(sample(1));
  episodes.begin(sample(2));
  episodes.observed(say("a"), at(2.5));
  CHECK(told(episodes) == "pointing|/; pointing|a/");
}

TEST_CASE("what was done before any input is no episode") {
  Episodes episodes(true, true);
  episodes.observed(say("a"), at(0));
  episodes.produced(say("b"), at(0));
  episodes.begin(words(1));
  CHECK(told(episodes) == "speech yes|/");
}

TEST_CASE("where not all are wanted, those that can still get moves are kept") {
  Episodes episodes(true, false);
  episodes.begin(words(1));
  episodes.produced(say("a"), at(1));
  episodes.begin(words(2));
  episodes.produced(say("b"), at(2));
  episodes.begin(sample(3));
  episodes.begin(sample(4));
  episodes.produced(say("c"), at(4.5));
  CHECK(told(episodes) == "speech yes|/bc; pointing|/");
}

TEST_CASE("episodes are held against what was observed") {
  Episodes episodes(true, true);
  episodes.begin(words(1));
  episodes.observed(say("The red block?"), at(1));
  episodes.produced(say("The black block?"), at(1));
  episodes.begin(words(2));
  episodes.produced(say("Yes?"), at(2));
  episodes.begin(sample(3));
  const auto all = episodes.take({{"red", "black"}});
  REQUIRE(all.size() == 3);
  CHECK(all[0].level == AgreementLevel::same_template);
  CHECK(all[1].level == AgreementLevel::none);
  CHECK(all[2].level == AgreementLevel::exact);
}
