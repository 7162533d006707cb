// How fast the automaton steps, on the machines of make_machines.py in the folder CONTINUA_BENCH, and how the time to
// decide whether a word is a palindrome grows with its length.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "continua/analysis/acceptance.h"
#include "continua/automaton/stepper.h"
#include "continua/core/located_json.h"
#include "continua/machine_file/machine_loader.h"

namespace continua {
namespace {

std::string folder() {
  const char* path = std::getenv("CONTINUA_BENCH");
  return path ? path : ".";
}

// The value, or the end of the program with the error.
template <class T>
T required(Result<T> result) {
  if (result) return *std::move(result);
  std::fprintf(stderr, "bench_automaton: %s\n", result.error().text().c_str());
  std::exit(2);
}

void step(benchmark::State& state, const std::string& name) {
  const auto machine = std::make_shared<const Machine>(required(load_machine(folder() + "/" + name + ".json", {})));
  const auto word = required(LocatedJson::read(folder() + "/word.json")).root();
  std::vector<Input> inputs;
  for (const auto& symbol : word) {
    Input input;
    input.symbol = symbol.get<std::string>();
    inputs.push_back(std::move(input));
  }
  const Rules no_facts;
  const Beliefs beliefs(machine->beliefs);
  const Facts facts{.beliefs = &beliefs};
  Chooser chooser;
  const Stepper stepper(machine, no_facts);
  for (auto _ : state) {
    auto configuration = stepper.initial();
    for (const auto& input : inputs) configuration = *stepper.advance(configuration, input, facts, chooser);
    benchmark::DoNotOptimize(configuration.state);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * inputs.size()));
}

const char* const palindromes = R"({"machine": 1, "name": "palindromes", "start": "first", "accept": ["end"],
  "slots": {"letter": "text"}, "transitions": [
  {"id": "push", "from": "first", "on": ["a", "b"], "to": "first", "push": {"letter": "input"}},
  {"id": "middle", "from": "first", "on": null, "to": "second"},
  {"id": "pop", "from": "second", "on": ["a", "b"], "when": "letter = input", "to": "second", "pop": 1},
  {"id": "end", "from": "second", "on": null, "when": "letter = null", "to": "end"}]})";

void accept(benchmark::State& state) {
  const auto machine = std::make_shared<const Machine>(required(parse_machine(palindromes, "palindromes", {})));
  std::vector<std::string> word(static_cast<std::size_t>(state.range(0)), "a");
  for (std::size_t i = 0; i < word.size() / 2; ++i)
    if (i * i % 7 % 2 == 0) word[i] = word[word.size() - 1 - i] = "b";
  for (auto _ : state) {
    Acceptance acceptance(machine);
    if (!required(acceptance.accepts(word))) state.SkipWithError("a palindrome is refused");
  }
}

BENCHMARK_CAPTURE(step, finite, "finite");
BENCHMARK_CAPTURE(step, stack, "stack");
BENCHMARK_CAPTURE(step, guarded, "guarded");
BENCHMARK(accept)->Arg(20)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace continua

BENCHMARK_MAIN();
