// How fast utterances are read, with the English lexicon.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "continua/facts/world_facts.h"
#include "continua/language/parser.h"
#include "support/folders.h"

namespace continua {
namespace {

const Vocabulary& vocabulary() {
  static const Vocabulary words = [] {
    auto lexicon = load_lexicon(source_dir() + "/engine/knowledge/lexicon/english", WorldFacts::signature());
    if (!lexicon) {
      std::fprintf(stderr, "bench_parser: %s\n", lexicon.error().text().c_str());
      std::exit(2);
    }
    return Vocabulary(std::make_shared<const Lexicon>(*std::move(lexicon)), WorldSnapshot());
  }();
  return words;
}

void read_text(benchmark::State& state, const std::string& text) {
  for (auto _ : state) benchmark::DoNotOptimize(read(text, vocabulary()));
  state.counters["words"] = static_cast<double>(read(text, vocabulary()).words.size());
}

void read_repeated(benchmark::State& state, const std::string& text) {
  std::string repeated;
  for (std::int64_t i = 0; i < state.range(0); ++i) repeated += text + " ";
  read_text(state, repeated);
}

BENCHMARK_CAPTURE(read_text, one_breath, "put the knife in the blue cup");
BENCHMARK_CAPTURE(
    read_text, twenty_words,
    "the green block right of the plate, behind the other green block and in front of the two red blocks");
BENCHMARK_CAPTURE(read_text, no_commas,
                  "put the green block right of the plate behind the other green block in front of the red cup");
BENCHMARK_CAPTURE(read_text, spoken,
                  "could you please um take the small red block that is next to the cup and put it on the plate");
BENCHMARK_CAPTURE(read_text, condition,
                  "if the knife is not on the plate then put the blue cup behind the yellow block otherwise lift it");
BENCHMARK_CAPTURE(read_repeated, sentences, "put the knife in the blue cup.")->RangeMultiplier(2)->Range(1, 16);
BENCHMARK_CAPTURE(read_repeated, no_stops, "put the knife in the blue cup")->RangeMultiplier(2)->Range(1, 2048);
BENCHMARK_CAPTURE(read_repeated, nonsense, "the of in")->Arg(4000);

}  // namespace
}  // namespace continua

BENCHMARK_MAIN();
