// NOISE.json and the tables of confusions: read, and their faults told.
#include "continua/replay/noise/noise.h"

#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

namespace continua {
namespace {

const std::filesystem::path knowledge = std::filesystem::path(source_dir()) / "engine/knowledge";

std::string fault_of(const std::string& text) {
  TemporaryFolder folder;
  const auto noise = read_noise(folder.file("n.json", text), knowledge);
  return noise ? "" : noise.error().text().substr(folder.path().string().size() + 1);
}

TEST_CASE("Faults of a noise have their place, the thing found and the thing expected") {
  CHECK(fault_of(R"({"noise":1})").empty());
  CHECK(fault_of(R"({"noise":1,"words":{"misheard":2}})") ==
        "n.json:1:32: found 2, expected a share, 0 to 1, a number from 0 to 1");
  CHECK(fault_of(R"({"noise":1,"words":{"misherd":0.2}})").find("did you mean 'misheard'?") != std::string::npos);
  CHECK(fault_of(R"({"noise":1,"words":{"misheard":0.7,"dropped":0.7}})").find("more than 1 together") !=
        std::string::npos);
  CHECK(fault_of(R"({"noise":1,"n_best":{"size":2,"truth":3}})").find("expected") != std::string::npos);
  CHECK(fault_of(R"({"noise":1,"words":{"misheard":0.1,"confusions":"none.json"}})").find("none.json") !=
        std::string::npos);
  CHECK(fault_of(R"({"nose":1})").starts_with("n.json:1:1: there is no \"noise\""));
}

TEST_CASE("One kind of noise alone, stronger or weaker, shares are 1 together at most") {
  Noise noise;
  noise.words = {0.1, 0.1, 0.3};
  noise.times.sd_s = 0.2;
  const auto half = only(noise, "words", 0.5), much = only(noise, "words", 4);
  CHECK(half.words.misheard == 0.15);
  CHECK(half.times.sd_s == 0);
  CHECK(much.words.dropped + much.words.swapped + much.words.misheard == Approx(1));
  CHECK(only(noise, "times", 3).times.sd_s == Approx(0.6));
}

TEST_CASE("The program's noise can be used, and its table has words that are heard for others") {
  const auto noise = read_noise("standard", knowledge);
  if (!noise) FAIL(noise.error().text());
  for (const auto& kind : noise_kinds()) CHECK(has_kind(*noise, kind));
  CHECK(noise->confusions.rows.size() > 100);
  CHECK(quantile(noise->confusions.sure_right, 0.5) > quantile(noise->confusions.sure_wrong, 0.5));
  for (const auto& [said, row] : noise->confusions.rows)
    for (const auto& [heard, count] : row) CHECK(heard != said);
}

}  // namespace
}  // namespace continua
