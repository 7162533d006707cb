#include "continua/perception/gaze.h"

#include <fmt/format.h>

#include "support/catch.h"

using namespace continua;

namespace {

GazeSample sample(double t_s, const std::string& object, double until_s = 0, double confidence = 1) {
  GazeSample sample;
  sample.t = SimTime::from_seconds(t_s);
  sample.until = std::max(sample.t, SimTime::from_seconds(until_s));
  sample.object = object;
  sample.confidence = confidence;
  sample.serial = static_cast<int>(t_s * 10);
  return sample;
}

// "plate 1.50 [10]; cup 0.50 [20]"
std::string salient(const std::vector<GazeSample>& samples, double now_s, double least = 0.1) {
  GazeTrack track;
  for (const auto& each : samples) track.add(each);
  std::string text;
  for (const auto& each : track.salient(SimTime::from_seconds(now_s), 2, least)) {
    text += fmt::format("{}{} {:.2f} [", text.empty() ? "" : "; ", each.object, each.salience);
    for (const int serial : each.serials)
      text += fmt::format("{}{}", serial == each.serials.front() ? "" : " ", serial);
    text += "]";
  }
  return text;
}

}  // namespace

TEST_CASE("a look is worth its seconds, and half of them after each half-life") {
  const std::vector<GazeSample> one = {sample(1, "plate", 2)};
  CHECK(salient(one, 1.5) == "plate 0.50 [10]");
  CHECK(salient(one, 2.5) == "plate 1.50 [10]");
  CHECK(salient(one, 4.5) == "plate 0.75 [10]");
  CHECK(salient(one, 12.5) == "");
}

TEST_CASE("a look ends with the next one, or when the tracker drops out") {
  CHECK(salient({sample(1, "plate"), sample(1.2, "cup")}, 1.2) == "plate 0.20 [10]");
  CHECK(salient({sample(1, "plate"), sample(1.2, "")}, 1.2) == "plate 0.20 [10]");
  CHECK(salient({sample(1, "plate")}, 1.5) == "plate 0.50 [10]");
  CHECK(salient({sample(1, "plate"), sample(1.4, "plate"), sample(1.8, "plate")}, 1.8) == "plate 0.80 [10]");
}

TEST_CASE("looks at one object add up, and count with their confidence") {
  CHECK(salient({sample(1, "plate", 1.4), sample(1.5, "cup", 1.6), sample(1.7, "plate", 2)}, 2, 0.5) ==
        "plate 0.72 [10 17]");
  CHECK(salient({sample(1, "plate", 2, 0.5), sample(2, "cup", 3)}, 3) == "cup 1.00 [20]; plate 0.35 [10]");
}

TEST_CASE("a sample from before the latest look is left out") {
  CHECK(salient({sample(2, "plate", 3), sample(1, "cup", 2)}, 3) == "plate 1.00 [20]");
}
