#include "continua/perception/fusion.h"

#include "perception/pointing_samples.h"
#include "perception/talk.h"
#include "support/catch.h"

using namespace continua;

namespace {

const FusionWindow window = {2, 1, 0};

struct Samples {
  double from_s, until_s, x, y;
  std::string hand = "right";
};

// The ensembles for a recogniser that reports everything at its time, to the end.
std::string fused(const std::vector<Percept>& percepts, const std::vector<Samples>& pointing = {},
                  FusionWindow w = window) {
  struct Arrival {
    SimTime t;
    const Percept* percept;
    InputEvent sample;
  };
  std::vector<Arrival> arrivals;
  Random random(1);
  for (const auto& [from_s, until_s, x, y, hand] : pointing)
    for (auto& event :
         pointing_samples([x = x, y = y](double) { return Vec3(x, y, 0); }, from_s, until_s, 20, {}, random, hand))
      arrivals.push_back({event.t, nullptr, event});
  for (const auto& percept : percepts) arrivals.push_back({percept.event.t, &percept, {}});
  std::stable_sort(arrivals.begin(), arrivals.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  Fusion fusion(w, around_table);
  std::vector<Ensemble> all;
  int serial = 100;
  for (const auto& arrival : arrivals) {
    for (auto due = fusion.due(); due && *due < arrival.t; due = fusion.due())
      for (auto& each : fusion.release(*due)) all.push_back(std::move(each));
    if (arrival.percept)
      REQUIRE(fusion.receive(*arrival.percept, arrival.t));
    else
      REQUIRE(fusion.sample(arrival.sample, serial++, arrival.t));
    for (auto& each : fusion.release(arrival.t)) all.push_back(std::move(each));
  }
  while (const auto due = fusion.due())
    for (auto& each : fusion.release(*due)) all.push_back(std::move(each));
  return brief(all);
}

std::vector<Said> put_it_there(double t) {
  return {{"put", t, t + 0.3}, {"it", t + 0.3, t + 0.5}, {"there", t + 0.5, t + 1}};
}
std::vector<Said> put_that_there(double t) {
  return {{"put", t, t + 0.3}, {"that", t + 0.3, t + 0.7}, {"there", t + 0.7, t + 1.2}};
}

}  // namespace

TEST_CASE("a word that points is complete with the stroke before, during or after it") {
  const auto there = speech(1, 2, put_it_there(2));
  CHECK(fused({there, gesture(2, 1, "point", 1.3)}) == "3.00 put it there [2]");
  CHECK(fused({there, gesture(2, 2.6, "point", 2.9)}) == "3.00 put it there [2]");
  CHECK(fused({there, gesture(2, 3.4, "point", 3.7)}) == "3.40 put it there [2]");
  CHECK(fused({there, gesture(2, 4, "point", 4.3)}) == "4.00 put it there [2]");
}

TEST_CASE("without a stroke in the window the word waits, then is released without") {
  const auto there = speech(1, 2, put_it_there(2));
  CHECK(fused({there}) == "4.00 put it there [-]");
  CHECK(fused({there, gesture(2, 4.1, "point", 4.2)}) == "4.00 put it there [-]; 5.20 point");
  CHECK(fused({there, gesture(2, 0.2, "point", 0.4)}) == "1.40 point; 4.00 put it there [-]");
}

TEST_CASE("speech that does not tell its times is taken to be as fast as speech usually is") {
  const auto there = speech(1, 2, put_it_there(2), false);
  CHECK(fused({there, gesture(2, 1.5, "point", 1.8)}) == "3.00 put it there [2]");
  CHECK(fused({there, gesture(2, 2.2, "point", 2.4)}) == "3.00 put it there [2]");
  CHECK(fused({there, gesture(2, 0.6, "point", 0.8)}) == "1.80 point; 3.00 put it there [2]");
  CHECK(fused({there, gesture(2, 0.6, "point", 0.8), gesture(3, 2.6, "point")}) == "1.80 point; 3.00 put it there [3]");
}

TEST_CASE("each word has its stroke") {
  const auto both = speech(1, 2, put_that_there(2));
  CHECK(fused({both, gesture(2, 2.3, "point", 2.5), gesture(3, 2.9, "point", 3.1)}) == "3.20 put that there [2] [3]");
  CHECK(fused({both, gesture(2, 1.6, "point"), gesture(3, 3.9, "point")}) == "3.90 put that there [2] [3]");
  CHECK(fused({both, gesture(2, 1.2, "point"), gesture(3, 1.6, "point")}) == "3.20 put that there [2] [3]");
  CHECK(fused({both, gesture(2, 3.3, "point"), gesture(3, 3.6, "point")}) == "3.60 put that there [2] [3]");
  // One of two hands each.
  CHECK(fused({both, gesture(2, 2.3, "point", 2.5, "left"), gesture(3, 2.4, "point", 3.1)}) ==
        "3.20 put that there [2] [3]");
}

TEST_CASE("one stroke goes to the nearest word") {
  const auto both = speech(1, 2, put_that_there(2));
  CHECK(fused({both, gesture(2, 2.3, "point", 2.5)}) == "4.20 put that there [2] [-]");
  CHECK(fused({both, gesture(2, 2.8, "point", 3.1)}) == "4.20 put that there [-] [2]");
  CHECK(fused({both, gesture(2, 1.6, "point", 1.8), gesture(3, 2.3, "point", 2.5), gesture(4, 2.8, "point", 3)}) ==
        "2.80 point; 3.20 put that there [3] [4]");
}

TEST_CASE("pointing alone waits for words, then says what it says") {
  CHECK(fused({gesture(1, 2, "point", 2.5)}) == "3.50 point");
  CHECK(fused({gesture(1, 2, "point", 2.5), speech(2, 3, {{"go", 3, 3.3}, {"on", 3.3, 3.5}})}) ==
        "3.50 point; 3.50 go on");
}

TEST_CASE("pointing that was released alone is taken by words that come within the window, once") {
  CHECK(fused({gesture(1, 1, "point", 1.2), speech(2, 2.3, {{"there", 2.3, 2.6}}),
               speech(3, 2.8, {{"here", 2.8, 3.1}})}) == "2.20 point; 2.60 there [1]; 4.10 here [-]");
}

TEST_CASE("words that do not point are understood when they have been said") {
  CHECK(fused({speech(1, 1, {{"hello", 1, 1.5}})}) == "1.50 hello");
  CHECK(fused({speech(1, 1, {{"the", 1, 1.2}, {"cup", 1.2, 1.5}})}) == "1.50 the cup [-]");
  CHECK(fused({gesture(2, 0.5, "point"), speech(1, 1, {{"the", 1, 1.2}, {"cup", 1.2, 1.5}})}) == "1.50 the cup [2]");
}

TEST_CASE("what is complete releases what began before it") {
  const auto there = speech(1, 2, put_it_there(2));
  CHECK(fused({there, gesture(2, 3.2, "posack")}) == "3.20 put it there [-]; 3.20 posack");
  CHECK(fused({there, gesture(2, 2.2, "posack"), gesture(3, 2.6, "point")}) == "3.00 put it there [3]; 3.00 posack");
  CHECK(fused({gesture(2, 1.5, "point"), speech(3, 1.8, {{"no", 1.8, 2}}), there}) == "2.00 no; 3.00 put it there [2]");
  // Pointing does not hurry words that wait for another.
  const auto both = speech(4, 5, put_that_there(5));
  CHECK(fused({both, gesture(5, 4.7, "point"), gesture(6, 6.5, "point")}) == "6.50 put that there [5] [6]");
}

TEST_CASE("of two utterances in quick succession each has its own pointing") {
  const auto first = speech(1, 1, {{"that", 1, 1.3}}), second = speech(2, 1.5, {{"there", 1.5, 1.8}});
  CHECK(fused({first, second, gesture(3, 1.1, "point"), gesture(4, 1.6, "point")}) == "1.30 that [3]; 1.80 there [4]");
  CHECK(fused({first, second, gesture(3, 1.4, "point"), gesture(4, 2.1, "point")}) == "1.40 that [3]; 2.10 there [4]");
  CHECK(fused({first, second, gesture(3, 1.7, "point")}) == "1.80 that [-]; 1.80 there [3]");
  CHECK(fused({first, second}) == "2.30 that [-]; 2.80 there [-]");
}

TEST_CASE("a steady hand is as good as a stroke") {
  const auto there = speech(1, 2, put_it_there(2));
  CHECK(fused({there}, {{1, 2.8, 0.1, 0.1}}) == "3.00 put it there [1.00-2.80 right]");
  CHECK(fused({there}, {{3.2, 4.5, 0.1, 0.1}}) == "3.50 put it there [3.20-3.50 right]");
  CHECK(fused({there}, {{0.2, 0.4, 0.1, 0.1}}) == "4.00 put it there [-]");
  CHECK(fused({speech(1, 2, put_it_there(2), false)}, {{1.8, 1.8, 0.1, 0.1}}) == "3.00 put it there [1.80-1.80 right]");
  const auto both = speech(1, 2, put_that_there(2));
  CHECK(fused({both}, {{2.1, 2.6, 0.1, 0.1}, {2.8, 3.2, -0.3, 0.1}}) ==
        "3.20 put that there [2.10-2.60 right] [2.80-3.20 right]");
  CHECK(fused({both}, {{2.1, 3.1, 0.1, 0.1, "left"}, {2.4, 3.3, -0.3, 0.1}}) ==
        "3.20 put that there [2.10-3.10 left] [2.40-3.20 right]");
}

TEST_CASE("samples of the hand that makes a stroke are no other pointing") {
  const auto both = speech(1, 2, put_that_there(2));
  CHECK(fused({both, gesture(2, 2.4, "point", 2.9)}, {{2, 3, 0.02, 0}}) == "4.20 put that there [2] [-]");
  CHECK(fused({both, gesture(2, 2.4, "point", 2.9)}, {{2, 3.4, -0.3, 0, "left"}}) ==
        "3.20 put that there [2.00-3.20 left] [2]");
}

TEST_CASE("what arrives out of order within the lateness is put in order") {
  Fusion fusion({2, 1, 0.5}, around_table);
  CHECK(fusion.receive(speech(1, 1, put_it_there(1)), at(1.4)));
  CHECK(fusion.due() == at(1.5));
  CHECK(fusion.release(at(1.5)).empty());
  CHECK(fusion.receive(gesture(3, 1.7, "posack"), at(1.8)));
  CHECK(fusion.receive(gesture(2, 1.6, "point"), at(2)));
  CHECK(fusion.release(at(2.2)).empty());
  CHECK(brief(fusion.release(at(2.5))) == "2.00 put it there [2]; 2.00 posack");
  CHECK_FALSE(fusion.due());
}

TEST_CASE("what arrives late goes by its own time with what waits then") {
  Fusion fusion(window, around_table);
  CHECK(fusion.receive(speech(1, 3, put_that_there(3)), at(3)));
  CHECK(fusion.release(at(3)).empty());
  CHECK(fusion.receive(gesture(2, 3.4, "point"), at(3.5)));
  CHECK(fusion.release(at(3.9)).empty());

  SECTION("a pointing of before the other") {
    CHECK(fusion.receive(gesture(3, 3.3, "point", 3.35), at(4)));
    CHECK(brief(fusion.release(at(4.2))) == "4.20 put that there [3] [2]");
  }
  SECTION("words to a pointing that was released alone") {
    CHECK(brief(fusion.release(at(5.3))) == "5.20 put that there [2] [-]");
    CHECK(fusion.receive(gesture(3, 5.25, "point"), at(5.8)));
    CHECK(brief(fusion.release(at(6.3))) == "6.25 point");
    CHECK(fusion.receive(speech(4, 5.4, {{"there", 5.4, 5.7}}), at(6.4)));
    CHECK(brief(fusion.release(at(6.4))) == "6.30 there [3]");
  }
  SECTION("samples") {
    for (int i = 0; i < 10; ++i) CHECK(fusion.sample(sample_at(3.8 + 0.04 * i, 0.2, 0), 10 + i, at(4.19)));
    CHECK(brief(fusion.release(at(4.3))) == "4.20 put that there [2] [3.80-4.16 right]");
  }
  SECTION("but not later than the window") {
    CHECK(fusion.release(at(6)).size() == 1);
    CHECK_FALSE(fusion.receive(gesture(3, 3.9, "point"), at(6)));
    CHECK_FALSE(fusion.sample(sample_at(3.9, 0.2, 0), 4, at(6)));
    CHECK(fusion.receive(gesture(5, 4, "posack"), at(6)));
    CHECK(brief(fusion.release(at(6))) == "6.00 posack");
  }
}

TEST_CASE("a sample that is to be understood too releases nothing") {
  Fusion fusion(window, around_table);
  CHECK(fusion.receive(speech(1, 1, {{"there", 1, 1.3}}), at(1)));
  CHECK(fusion.receive(gesture(2, 2, "point"), at(2)));
  CHECK(brief(fusion.release(at(2))) == "2.00 there [2]");
  CHECK(fusion.receive(speech(3, 3, {{"there", 3, 3.3}}), at(3)));
  Percept sample;
  sample.serial = 4;
  sample.event = sample_at(3.1, 0, 0);
  CHECK(fusion.receive(sample, at(3.1)));
  CHECK(brief(fusion.release(at(3.1))) == "3.10 ");
  CHECK(brief(fusion.release(at(5))) == "4.30 there [-]");
}

TEST_CASE("a gesture at the time of a word is received before both are released") {
  Fusion fusion(window, around_table);
  CHECK(fusion.receive(speech(1, 1, {{"there", 1, 1}}), at(1)));
  CHECK(fusion.receive(gesture(2, 1, "posack"), at(1)));
  CHECK(fusion.receive(gesture(3, 1, "point"), at(1)));
  CHECK(brief(fusion.release(at(1))) == "1.00 there [3]; 1.00 posack");
}

TEST_CASE("a pointing made with other words waits for one that is made with the word") {
  const auto cup_here = speech(1, 2, {{"put", 2, 2.2}, {"cup", 2.2, 2.6}, {"here", 3, 3.3}});
  CHECK(fused({cup_here, gesture(2, 2.3, "point", 2.5), gesture(3, 3.8, "point", 4)}) == "3.80 put cup here [2] [3]");
  CHECK(fused({cup_here, gesture(2, 2.3, "point", 2.5)}) == "4.30 put cup here [-] [2]");
}

TEST_CASE("a pointing shortly before an utterance goes with any of its words") {
  auto there = speech(1, 2, {{"put", 2, 2.3}, {"it", 2.3, 2.5}, {"there", 4.5, 5}});
  CHECK(fused({there, gesture(2, 1.6, "point", 1.8)}) == "2.80 point; 6.00 put it there [-]");
  for (auto& taker : there.takers) taker.begun = at(2);
  CHECK(fused({there, gesture(2, 1.6, "point", 1.8)}) == "5.00 put it there [2]");
}

namespace {

// Two utterances, the first of which may go on; joined as one that may not.
std::string in_pieces(double second_s, FusionWindow w) {
  Percept first = speech(1, 1, {{"the", 1, 1.2}, {"cup", 1.2, 1.5}});
  first.unfinished = true;
  first.spoken = at(1.5);
  Percept second = speech(2, second_s, {{"behind", second_s, second_s + 0.4}});
  second.spoken = at(second_s + 0.4);
  Fusion fusion(w, around_table);
  std::vector<Ensemble> all;
  const Joining joining = [](const Percept& a, const Percept& b) {
    Percept whole = b;
    whole.event.t = a.event.t;
    whole.event.text = a.event.text + " " + b.event.text;
    whole.pieces = {a.serial};
    return whole;
  };
  const auto release = [&](SimTime now) {
    for (auto& each : fusion.release(now, joining)) all.push_back(std::move(each));
  };
  REQUIRE(fusion.receive(first, at(1)));
  release(at(1));
  while (fusion.due() && *fusion.due() < second.event.t) release(*fusion.due());
  REQUIRE(fusion.receive(second, second.event.t));
  release(second.event.t);
  while (const auto due = fusion.due()) release(*due);
  return brief(all);
}

}  // namespace

TEST_CASE("an unfinished sentence waits for its next piece as long as the window says") {
  CHECK(in_pieces(2.4, {2, 1, 0, 1}) == "2.80 the cup behind");
  CHECK(in_pieces(2.6, {2, 1, 0, 1}) == "2.50 the cup [-]; 3.00 behind");
  CHECK(in_pieces(2.4, {2, 1, 0, 0}) == "1.50 the cup [-]; 2.80 behind");
}

TEST_CASE("a pointing with the last words of an unfinished sentence makes it wait longer") {
  const auto heard = [](double word_s, double pointing_s, double more_s) {
    Percept first = speech(1, 1, {{"there", word_s, word_s + 0.3}});
    first.unfinished = true;
    first.spoken = at(1.4);
    Fusion fusion({2, 1, 0, 1}, around_table);
    const Joining joining = [](const Percept& a, const Percept& b) {
      Percept whole = a;
      whole.event.text = a.event.text + " " + b.event.text;
      whole.unfinished = false;
      return whole;
    };
    std::vector<Ensemble> all;
    const auto go_on = [&](double t_s) {
      while (fusion.due() && *fusion.due() < at(t_s))
        for (auto& each : fusion.release(*fusion.due(), joining)) all.push_back(std::move(each));
    };
    REQUIRE(fusion.receive(first, at(1)));
    go_on(pointing_s);
    REQUIRE(fusion.receive(gesture(2, pointing_s, "point"), at(pointing_s)));
    go_on(more_s);
    REQUIRE(fusion.receive(speech(3, more_s, {{"please", more_s, more_s + 0.3}}), at(more_s)));
    for (auto& each : fusion.release(at(more_s), joining)) all.push_back(std::move(each));
    go_on(20);
    return brief(all);
  };
  CHECK(heard(1.1, 2, 2.9) == "2.90 there please [2]");
  CHECK(heard(1.1, 2, 3.1) == "3.00 there [2]; 3.40 please");
  // With earlier words the pointing makes no difference.
  CHECK(heard(1.0, 2, 2.9) == "2.40 there [2]; 3.20 please");
}

TEST_CASE("a gesture of which the beginning alone is told points where its hand dwells") {
  auto begun = gesture(1, 2, "point");
  begun.event.phase = "start";
  begun.deixis = deixis_of(begun.event, 1);
  const auto place = [&](const std::vector<InputEvent>& samples) {
    Fusion fusion(window, around_table);
    REQUIRE(fusion.receive(speech(2, 1, {{"that", 1, 1.4}}), at(1)));
    REQUIRE(fusion.receive(begun, at(2)));
    std::vector<Ensemble> released = fusion.release(at(2));
    int serial = 3;
    for (const auto& sample : samples) {
      REQUIRE(fusion.sample(sample, serial++, sample.t));
      for (auto& each : fusion.release(sample.t)) released.push_back(std::move(each));
    }
    for (auto& each : fusion.release_all()) released.push_back(std::move(each));
    REQUIRE(released.size() == 1);
    const auto& bound = released[0].bound.at(0);
    REQUIRE(bound);
    CHECK(bound->serials.front() == 1);
    return bound->place_W;
  };
  std::vector<InputEvent> dwell = {sample_at(2.02, 0.28, 0.1)};
  for (int i = 1; i < 12; ++i) dwell.push_back(sample_at(2.02 + 0.04 * i, 0.2, 0.1));
  CHECK(place(dwell) == Vec3(0.2, 0.1, 0));
  CHECK(place({}) == *begun.event.target_W);
}

TEST_CASE("a gesture that says how words are meant comes before them") {
  const auto blocks = speech(1, 1, {{"lift", 1, 1.4}, {"blocks", 1.4, 2}});
  auto fingers = gesture(2, 1.6, "two");
  CHECK(fused({blocks, fingers}) == "2.00 lift blocks; 2.00 two");
  fingers.before_words = true;
  CHECK(fused({blocks, fingers}) == "2.00 two; 2.00 lift blocks");
}
