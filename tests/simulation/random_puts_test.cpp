// Two hundred puts at random, judged from outside: random_puts.h. More of them, seed by seed: tests/bench/bench_puts.
#include "random_puts.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

TEST_CASE("of two hundred random puts nearly all are done, millimetres from where they should, and none tells a lie") {
  std::vector<PutTrial> trials;
  for (const auto& [scene, puts] :
       {std::pair("staircase", 110), std::pair("place_setting", 40), std::pair("emre_table", 50)}) {
    const auto of_scene = random_puts(std::string(source_dir() + "/mjcf/scenes/") + scene + ".xml", 1, puts);
    trials.insert(trials.end(), of_scene.begin(), of_scene.end());
  }
  const PutFigures figures = figures_of(trials);
  CAPTURE(figures.counted, figures.done, figures.refused, figures.median_m, figures.most_m, figures.failures);
  CHECK(figures.counted == 200);
  CHECK(figures.done * 100 >= figures.counted * 97);
  CHECK(figures.median_m < 0.005);
  CHECK(figures.most_m < 0.015);
  CHECK(figures.refused > 0);
  CHECK(figures.lies == std::vector<std::string>());
  CHECK(figures.depths == std::vector<std::string>());
}
