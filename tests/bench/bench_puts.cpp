// Random puts over scenes, seed by seed: bench_puts SEEDS PUTS SCENE.xml… writes a table, and the failures.
#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

#include "simulation/random_puts.h"

using namespace continua;

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "bench_puts SEEDS PUTS SCENE.xml…\n");
    return 2;
  }
  const int seeds = std::atoi(argv[1]), puts = std::atoi(argv[2]);
  fmt::print(
      "| scene | seed | puts | done | refused of all | median, mm | 95 %, mm | deepest, mm | wall s per put |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  std::vector<std::string> wrong;
  for (int i = 3; i < argc; ++i) {
    for (int seed = 1; seed <= seeds; ++seed) {
      const auto before = std::chrono::steady_clock::now();
      const auto figures = figures_of(random_puts(argv[i], static_cast<std::uint64_t>(seed), puts));
      const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - before;
      const std::string path = argv[i];
      fmt::print("| {} | {} | {} | {} ({:.1f} %) | {} of {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} |\n",
                 path.substr(path.rfind('/') + 1), seed, figures.counted, figures.done,
                 100.0 * figures.done / std::max(1, figures.counted), figures.refused, figures.trials,
                 1000 * figures.median_m, 1000 * figures.most_m, 1000 * figures.deepest_m,
                 wall.count() / std::max(1, figures.trials));
      std::fflush(stdout);
      for (const auto& list : {figures.failures, figures.lies, figures.depths})
        wrong.insert(wrong.end(), list.begin(), list.end());
    }
  }
  for (const auto& line : wrong) fmt::print("- {}\n", line);
}
