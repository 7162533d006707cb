#include "continua/perception/deixis.h"

#include <fmt/format.h>

#include <algorithm>

#include "perception/pointing_samples.h"
#include "support/catch.h"

using namespace continua;

namespace {

const Vec3 a_W(-0.2, 0.1, 0), b_W(0.25, -0.1, 0);

std::function<Vec3(double)> stays_at(const Vec3& p_W) {
  return [p_W](double) { return p_W; };
}

double away(const Deixis& deixis, const Vec3& p_W) { return (deixis.place_W - p_W).norm(); }

// "right 1.00-2.00 (-0.20, 0.10)": places to the centimetre.
std::string brief(const std::vector<Deixis>& fixations) {
  std::string text;
  for (const auto& each : fixations)
    text += fmt::format("{}{} {:.2f}-{:.2f} ({:.2f}, {:.2f})", text.empty() ? "" : "; ", each.hand, each.from.seconds(),
                        each.until.seconds(), each.place_W.x(), each.place_W.y());
  return text;
}

std::vector<InputEvent> joined(std::vector<InputEvent> a, const std::vector<InputEvent>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("a steady hand is one fixation of its whole time, at any rate") {
  const double hz = GENERATE(10, 20, 30, 60, 120);
  CAPTURE(hz);
  Random random(1);
  const auto events = pointing_samples(stays_at(a_W), 1, 4, hz, {0.01, 0, 0, {}, 0}, random);
  const auto found = fixations_of(events);
  REQUIRE(found.size() == 1);
  CHECK(found[0].from.seconds() == Approx(1));
  CHECK(found[0].until.seconds() == Approx(4).margin(1e-6));
  CHECK(away(found[0], a_W) < 0.008);
  CHECK(found[0].spread_m == Approx(0.01).epsilon(0.4));
  CHECK(found[0].samples == static_cast<int>(events.size()));
  CHECK(found[0].left_out == 0);
  CHECK(found[0].serials.size() == events.size());
  CHECK(std::is_sorted(found[0].serials.begin(), found[0].serials.end()));
  CHECK_FALSE(found[0].gesture);
}

TEST_CASE("a single sample is a fixation of its instant, or of as long as it says") {
  auto event = sample_at(2, 0.1, 0.2, "left");
  CHECK(brief(fixations_of({event})) == "left 2.00-2.00 (0.10, 0.20)");
  event.until = SimTime::from_seconds(3.5);
  CHECK(brief(fixations_of({event})) == "left 2.00-3.50 (0.10, 0.20)");
  CHECK(brief(fixations_of({sample_at(1, 0.1, 0, ""), sample_at(1.4, 0.3, 0, "")})) ==
        " 1.00-1.00 (0.10, 0.00);  1.40-1.40 (0.30, 0.00)");
}

TEST_CASE("rays are where they meet the table, and nowhere if they do not") {
  auto event = sample_at(1, 0, 0);
  event.target_W.reset();
  event.ray = Ray{{0, -0.6, 0.4}, {0.1, 0.5, -0.4}};
  CHECK(brief(fixations_of({event})) == "right 1.00-1.00 (0.10, -0.10)");
  event.ray = Ray{{0, -0.6, 0.4}, {0.1, 0.5, 0.4}};
  CHECK(fixations_of({event}).empty());
  event.ray = Ray{{0, -0.6, 0.4}, {0.1, 0.5, -1e-9}};
  CHECK(fixations_of({event}).empty());
}

TEST_CASE("what is not a number or is beyond the area is not believed, and counted") {
  std::vector<InputEvent> events;
  for (int i = 0; i < 40; ++i) events.push_back(sample_at(1 + i / 30.0, -0.2, 0.1));
  events[10].target_W = Vec3(1e8, 0, 0);
  events[11].target_W = Vec3(-4e3, 2e4, 0);
  events[12].target_W = Vec3(std::nan(""), 0, 0);
  events[25].target_W = Vec3(0.4, -0.3, 0);  // on the table, but elsewhere
  const auto found = fixations_of(events);
  CHECK(brief(found) == "right 1.00-2.30 (-0.20, 0.10)");
  REQUIRE(found.size() == 1);
  CHECK(found[0].samples == 36);
  CHECK(found[0].left_out == 4);
  CHECK(found[0].spread_m == 0);
}

TEST_CASE("a tracker that flickers is where it is most of the time") {
  const double flicker_s = GENERATE(0.1, 0.15, 0.2);
  const double hz = GENERATE(20, 30, 60);
  const Vec3 astray_W = GENERATE(Vec3(2e3, -5e3, 0), Vec3(0.3, 0.3, 0), Vec3(0, 0.1, 0));
  CAPTURE(flicker_s, hz, astray_W.x());
  Random random(1);
  const auto found = fixations_of(pointing_samples(stays_at(a_W), 1, 4, hz, {0.01, 0, flicker_s, astray_W, 0}, random));
  REQUIRE(found.size() == 1);
  CHECK(away(found[0], a_W) < 0.01);
  CHECK(found[0].left_out > found[0].samples / 3);
  CHECK((found[0].until - found[0].from).seconds() > 2.5);
}

TEST_CASE("dropouts do not divide a fixation, pauses do") {
  Random random(1);
  const auto first = pointing_samples(stays_at(a_W), 1, 2, 30, {}, random);
  const auto soon = pointing_samples(stays_at(a_W), 2.4, 3, 30, {}, random);
  const auto later = pointing_samples(stays_at(a_W), 2.8, 3.4, 30, {}, random);
  CHECK(brief(fixations_of(joined(first, soon))) == "right 1.00-3.00 (-0.20, 0.10)");
  CHECK(brief(fixations_of(joined(first, later))) == "right 1.00-2.00 (-0.20, 0.10); right 2.80-3.40 (-0.20, 0.10)");
}

TEST_CASE("two hands point at once, or one after the other") {
  Random random(1);
  const auto right = pointing_samples(stays_at(a_W), 1, 2, 30, {}, random, "right");
  const auto left = pointing_samples(stays_at(b_W), 1.5, 2.5, 30, {}, random, "left");
  CHECK(brief(fixations_of(joined(right, left))) == "right 1.00-2.00 (-0.20, 0.10); left 1.50-2.50 (0.25, -0.10)");
  const auto then = pointing_samples(stays_at(a_W), 2.1, 3, 30, {}, random, "left");
  CHECK(fixations_of(joined(right, then)).size() == 1);  // the same place: the tracker took one hand for the other
}

TEST_CASE("a movement is no fixation, where it ends is") {
  // Slow to fast, metres a second; from A to B it is half a metre.
  const double speed = GENERATE(0.4, 0.7, 1.5);
  const double hz = GENERATE(15, 30, 60);
  const double sd_m = GENERATE(0, 0.01);
  CAPTURE(speed, hz, sd_m);
  const double way_s = (b_W - a_W).norm() / speed;
  const auto where = [&](double t) -> Vec3 { return a_W + std::clamp((t - 2) / way_s, 0.0, 1.0) * (b_W - a_W); };
  Random random(1);
  const auto found = fixations_of(pointing_samples(where, 1, 3.5 + way_s, hz, {sd_m, 0, 0, {}, 0}, random));
  REQUIRE(found.size() == 2);
  CHECK(away(found[0], a_W) < 0.015);
  CHECK(away(found[1], b_W) < 0.015);
  CHECK(found[0].until.seconds() == Approx(2).margin(0.25));
  CHECK(found[1].from.seconds() == Approx(2 + way_s).margin(0.25));
}

TEST_CASE("of a slow drift a fixation is where the hand is then") {
  const double speed = GENERATE(0.01, 0.03, 0.05);
  CAPTURE(speed);
  const auto where = [&](double t) -> Vec3 { return a_W + Vec3(speed * t, 0, 0); };
  Random random(1);
  const auto found = fixations_of(pointing_samples(where, 0, 6, 30, {0.01, 0, 0, {}, 0}, random));
  REQUIRE_FALSE(found.empty());
  double pointing_s = 0;
  for (const auto& each : found) {
    pointing_s += (each.until - each.from).seconds();
    for (const auto t : {each.from, each.until}) CHECK(away(each, where(t.seconds())) < 0.06);
  }
  CHECK(pointing_s > 5.5);
}

TEST_CASE("a gesture with a target is a pointing, its stop is none") {
  InputEvent event = sample_at(2, 0.1, 0.2, "left");
  CHECK_FALSE(deixis_of(event, 7));
  event.modality = Modality::gesture;
  event.phase = "start";
  event.until = SimTime::from_seconds(2.5);
  event.confidence = 0.8;
  const auto deixis = deixis_of(event, 7);
  REQUIRE(deixis);
  CHECK(brief({*deixis}) == "left 2.00-2.50 (0.10, 0.20)");
  CHECK(deixis->gesture);
  CHECK(deixis->confidence == 0.8);
  CHECK(deixis->serials == std::vector<int>{7});
  event.phase = "stop";
  CHECK_FALSE(deixis_of(event, 7));
  event.phase = "start";
  event.target_W = Vec3(std::nan(""), 0, 0);
  CHECK_FALSE(deixis_of(event, 7));
}

TEST_CASE("samples count with their confidence: in the place, and in the time that a hand has to stay") {
  const auto stay = [](double x, double until_s, double confidence) {
    std::vector<InputEvent> events;
    for (double t = 1; t < until_s; t += 1.0 / 30) events.push_back(sample_at(t, x, 0.1));
    for (auto& each : events) each.confidence = confidence;
    return events;
  };
  const auto crossing = [&](double confidence) {
    return joined(stay(0.1, 1.4, confidence), {sample_at(1.42, 0.4, 0.1)});
  };
  CHECK(fixations_of(crossing(1)).size() == 1);
  CHECK(fixations_of(crossing(0.5)).empty());

  const auto other = stay(0.14, 2, 1);
  auto both = stay(0.1, 2, 0.02);
  both.insert(both.end(), other.begin(), other.end());
  std::stable_sort(both.begin(), both.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  const auto found = fixations_of(both);
  REQUIRE(found.size() == 1);
  CHECK(away(found[0], Vec3(0.14, 0.1, 0)) < 1e-6);
}
