// The targets without libFuzzer, for every build: reads all seeds and findings, then mutations of them for a while.
//
//   fuzz_mutate SECONDS SEED [TARGET…]      of processor time, for each target
//   fuzz_mutate --seeds TARGET FOLDER       writes the target's seeds there
//   fuzz_mutate --words TARGET              prints the words of its schema and seeds, as a dictionary of libFuzzer
//   fuzz_mutate --list
//
// The input of which the program dies, or that takes too long, is then in the file fuzz-TARGET.
#include <signal.h>
#include <sys/time.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>

#include "fuzz/targets.h"

namespace continua {
namespace {

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr unsigned most_s = 10;  // for one input

// The input under way. To write a file for each would take longer than to read the inputs.
const FuzzTarget* target_under_way = nullptr;
const std::string* input_under_way = nullptr;

// Keeps the input and ends as the signal would have ended the program.
void keep_input(int signal_number) {
  if (target_under_way && input_under_way) {
    const std::string file = "fuzz-" + target_under_way->name;
    std::ofstream(file, std::ios::binary) << *input_under_way;
    std::fprintf(stderr, "%s: signal %d; the input is in %s\n", target_under_way->name.c_str(), signal_number,
                 file.c_str());
  }
  signal(signal_number, SIG_DFL);
  raise(signal_number);
}

// On a stack of its own, since a reader may have used up the program's.
void keep_inputs() {
  static std::array<char, 1 << 16> memory;
  const stack_t stack{memory.data(), 0, memory.size()};
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = keep_input;
  action.sa_flags = SA_ONSTACK;
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGPROF}) sigaction(number, &action, nullptr);
}

// An input that is no input as it should be: bytes are changed, moved, left out, said twice, or come from another one.
std::string mutated(std::string text, const std::vector<std::string>& seeds, const std::vector<std::string>& words,
                    std::mt19937& draw) {
  const auto below = [&](std::size_t count) { return count == 0 ? 0 : draw() % count; };
  for (auto times = 1 + below(4); times > 0; --times) {
    const auto at = below(text.size() + 1), size = below(std::min<std::size_t>(text.size() - at, 64) + 1);
    switch (below(8)) {
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
        constexpr const char* signs[] = {
            "\"", "{",    "}", "[", "]",  "null", "-1", "1e999", "18446744073709551616", "\\u0000", "\xff", "<",
            "/>", "&#0;", "(", ")", "\n", "\r\n", ",",  ":"};
        text.insert(at, signs[below(std::size(signs))]);
        break;
      }
      case 6:
        if (!words.empty()) text.replace(at, size, words[below(words.size())]);
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
    }
    if (text.size() > 65536) text.resize(65536);
  }
  return text;
}

void attack(const FuzzTarget& target, double seconds, unsigned seed) {
  auto seeds = fuzz_seeds(target);
  seeds.push_back("");
  const auto words = fuzz_words(target);
  std::mt19937 draw(seed);
  std::size_t count = 0;
  const auto run = [&](const std::string& input) {
    target_under_way = &target;
    input_under_way = &input;
    const itimerval limit{{}, {most_s, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    target.read(input);
    ++count;
  };
  const double begun = processor_s();
  for (const auto& one : seeds) {
    run(one);
    if (processor_s() - begun > seconds / 2) break;  // of many, those at the beginning
  }
  while (processor_s() - begun < seconds) run(mutated(seeds[draw() % seeds.size()], seeds, words, draw));
  input_under_way = nullptr;
  std::printf("%s: %zu inputs, %zu seeds, %.1f s\n", target.name.c_str(), count, seeds.size(), processor_s() - begun);
  std::fflush(stdout);
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
  if (words.size() == 2 && words[0] == "--words" && fuzz_target(words[1])) {
    for (const auto& word : fuzz_words(*fuzz_target(words[1]))) std::printf("\"%s\"\n", word.c_str());
    return 0;
  }
  if (words.size() < 2) return std::fprintf(stderr, "expected SECONDS SEED [TARGET...]\n"), 2;
  keep_inputs();
  for (const auto& target : fuzz_targets())
    if (words.size() == 2 || std::find(words.begin() + 2, words.end(), target.name) != words.end())
      attack(target, std::atof(words[0].c_str()), static_cast<unsigned>(std::atoi(words[1].c_str())));
  return 0;
}

}  // namespace
}  // namespace continua

int main(int count, char** words) { return continua::run({words + 1, words + count}); }
