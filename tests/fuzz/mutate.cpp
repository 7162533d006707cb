// The targets without libFuzzer, for every build: reads all seeds and findings, then mutations of them for a while.
//
//   fuzz_mutate SECONDS SEED [TARGET…]      of processor time, for each target
//   fuzz_mutate --seeds TARGET FOLDER       writes the target's seeds there
//   fuzz_mutate --list
//
// The input under way is in the file fuzz-TARGET, for when the program dies of it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>

#include "fuzz/targets.h"

namespace continua {
namespace {

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr double most_s = 10;  // for one input

// An input that is no input as it should be: bytes are changed, moved, left out, said twice, or come from another one.
std::string mutated(std::string text, const std::vector<std::string>& seeds, std::mt19937& draw) {
  const auto below = [&](std::size_t count) { return count == 0 ? 0 : draw() % count; };
  for (auto times = 1 + below(4); times > 0; --times) {
    const auto at = below(text.size() + 1), size = below(std::min<std::size_t>(text.size() - at, 64) + 1);
    switch (below(7)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(draw());
        break;
      case 1:
        text.erase(at, size);
        break;
      case 2:
        text.insert(below(text.size() + 1), text.substr(at, size));
        break;
      case 3:
        text.resize(at);
        break;
      case 4: {
        const auto& other = seeds[below(seeds.size())];
        text.insert(at, other.substr(below(other.size()), below(256)));
        break;
      }
      case 5: {
        constexpr const char* words[] = {
            "\"", "{",    "}", "[", "]",  "null", "-1", "1e999", "18446744073709551616", "\\u0000", "\xff", "<",
            "/>", "&#0;", "(", ")", "\n", "\r\n", ",",  ":"};
        text.insert(at, words[below(std::size(words))]);
        break;
      }
      default:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
    }
    if (text.size() > 65536) text.resize(65536);
  }
  return text;
}

// Whether each input is read soon.
bool attack(const FuzzTarget& target, double seconds, unsigned seed) {
  auto seeds = fuzz_seeds(target);
  seeds.push_back("");
  std::mt19937 draw(seed);
  std::size_t count = 0;
  const auto run = [&](const std::string& input) {
    std::ofstream("fuzz-" + target.name, std::ios::binary) << input;
    const double begun = processor_s();
    target.read(input);
    ++count;
    if (processor_s() - begun < most_s) return true;
    std::fprintf(stderr, "%s: an input takes %.0f s; it is in fuzz-%s\n", target.name.c_str(), processor_s() - begun,
                 target.name.c_str());
    return false;
  };
  const double begun = processor_s();
  for (const auto& one : seeds) {
    if (!run(one)) return false;
    if (processor_s() - begun > seconds / 2) break;  // of many, those at the beginning
  }
  while (processor_s() - begun < seconds)
    if (!run(mutated(seeds[draw() % seeds.size()], seeds, draw))) return false;
  std::printf("%s: %zu inputs, %zu seeds, %.1f s\n", target.name.c_str(), count, seeds.size(), processor_s() - begun);
  std::fflush(stdout);
  std::remove(("fuzz-" + target.name).c_str());
  return true;
}

int run(const std::vector<std::string>& words) {
  if (!words.empty() && words[0] == "--list") {
    for (const auto& target : fuzz_targets()) std::printf("%s\n", target.name.c_str());
    return 0;
  }
  if (words.size() == 3 && words[0] == "--seeds" && fuzz_target(words[1])) {
    int number = 0;
    for (const auto& seed : fuzz_seeds(*fuzz_target(words[1])))
      std::ofstream(words[2] + "/seed-" + std::to_string(number++), std::ios::binary) << seed;
    return 0;
  }
  if (words.size() < 2) return std::fprintf(stderr, "expected SECONDS SEED [TARGET...]\n"), 2;
  bool fine = true;
  for (const auto& target : fuzz_targets())
    if (words.size() == 2 || std::find(words.begin() + 2, words.end(), target.name) != words.end())
      fine = attack(target, std::atof(words[0].c_str()), static_cast<unsigned>(std::atoi(words[1].c_str()))) && fine;
  return fine ? 0 : 1;
}

}  // namespace
}  // namespace continua

int main(int count, char** words) { return continua::run({words + 1, words + count}); }
