#include "continua/perception/speech_times.h"

#include <fmt/format.h>

#include "support/catch.h"

using namespace continua;

namespace {

struct Told {
  std::string text;
  double t_s;
};

InputEvent speech(double t_s, std::optional<double> until_s, const std::vector<Told>& words) {
  InputEvent event;
  event.t = SimTime::from_seconds(t_s);
  if (until_s) event.until = SimTime::from_seconds(*until_s);
  for (const auto& [text, at_s] : words) event.words.push_back({text, SimTime::from_seconds(at_s)});
  return event;
}

std::string times(const InputEvent& event, const std::vector<std::string>& words) {
  std::string text;
  for (const auto& [from, until] : word_times(event, words))
    text += fmt::format("{}{:.2f}-{:.2f}", text.empty() ? "" : " ", from.seconds(), until.seconds());
  return text;
}

}  // namespace

TEST_CASE("without times words take their usual time together, each by its length") {
  CHECK(times(speech(1, {}, {}), {"put", "it", "there"}) == "1.00-1.31 1.31-1.52 1.52-2.05");
  CHECK(times(speech(1, {}, {}), {"ok", ",", "there"}) == "1.00-1.20 1.20-1.20 1.20-1.70");
  CHECK(times(speech(1, {}, {}), {}).empty());
  CHECK(times(speech(1, {}, {}), {","}) == "1.00-1.00");
  CHECK(time_of(speech(1, {}, {}), {"put", "it", "there"}).until.seconds() == Approx(2.05));
}

TEST_CASE("with an end they fill the time to it") {
  CHECK(times(speech(1, 2.0, {}), {"put", "it", "there"}) == "1.00-1.30 1.30-1.50 1.50-2.00");
  CHECK(times(speech(1, 5.0, {}), {"there"}) == "1.00-5.00");
  CHECK(time_of(speech(1, 2.0, {}), {"put", "it", "there"}).until.seconds() == 2);
  CHECK(time_of(speech(1, 2.0, {}), {}).until.seconds() == 2);
}

TEST_CASE("words that were told begin when they did") {
  const auto told = speech(1, 3.0, {{"Put", 1.1}, {"it", 1.5}, {"there.", 2.4}});
  CHECK(times(told, {"put", "it", "there"}) == "1.10-1.50 1.50-2.20 2.40-3.00");
  CHECK(times(speech(1, {}, {{"put", 1.1}, {"it", 1.5}, {"there", 1.7}}), {"put", "it", "there"}) ==
        "1.10-1.50 1.50-1.70 1.70-2.05");
  // A word that occurs twice: each occurrence in its turn.
  CHECK(times(speech(1, 2.2, {{"that", 1.0}, {"on", 1.5}, {"that", 1.8}}), {"that", "on", "that"}) ==
        "1.00-1.50 1.50-1.80 1.80-2.20");
}

TEST_CASE("words that were not told are between those that were") {
  CHECK(times(speech(1, 3.0, {{"put", 1.0}, {"there", 2.0}}), {"put", "it", "there"}) ==
        "1.00-1.60 1.60-2.00 2.00-2.70");
  CHECK(times(speech(1, 2.0, {{"there", 1.6}}), {"it", "there"}) == "1.00-1.60 1.60-2.00");
  CHECK(times(speech(1, 2.0, {{"there", 1.6}}), {"quite", "else"}) == "1.00-1.56 1.56-2.00");
}

TEST_CASE("times that contradict each other give spans in order nevertheless") {
  CHECK(times(speech(2, 3.0, {{"put", 1.0}, {"it", 9.0}, {"there", 2.5}}), {"put", "it", "there"}) ==
        "2.00-2.70 9.00-9.00 9.00-9.00");
  CHECK(time_of(speech(2, 1.0, {}), {"put"}).until.seconds() == 2);
  CHECK(times(speech(2, 1.0, {}), {"put"}) == "2.00-2.00");
}
