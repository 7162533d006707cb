// Random puts over scenes, seed by seed: bench_puts SEEDS PUTS SCENE.xml… writes a table, and the failures.
#include <chrono>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "simulation/random_puts.h"

using namespace continua;

namespace {

/// Writes the scene's rows of the table and adds to `wrong`. Throws for an arm that cannot be judged.
void measure(const std::string& path, int seeds, int puts, std::vector<std::string>& wrong) {
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto before = std::chrono::steady_clock::now();
    const auto figures = figures_of(random_puts(path, static_cast<std::uint64_t>(seed), puts));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - before;
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

}  // namespace

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
    try {
      measure(argv[i], seeds, puts, wrong);
    } catch (const std::invalid_argument& fault) {
      fmt::print(stderr, "left out: {}: {}\n", argv[i], fault.what());
    }
  }
  for (const auto& line : wrong) fmt::print("- {}\n", line);
}
