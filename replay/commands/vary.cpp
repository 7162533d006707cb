#include "continua/replay/commands/vary.h"

#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/commands/moved_paths.h"
#include "continua/replay/noise/vary.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

Outcome vary(const VaryOptions& options) {
  const auto data = find_data_paths(options.knowledge);
  if (!data) return data.error();
  const auto noise = read_noise(options.noise, data->knowledge);
  if (!noise) return noise.error();
  const auto trace = read_trace(options.trace);
  if (!trace) return trace.error();
  std::error_code problem;
  fs::create_directories(options.output, problem);
  if (problem) return Error{options.output, fmt::format("cannot be made a folder: {}", problem.message())};
  const auto digits = std::to_string(options.count).size();
  for (int i = 0; i < options.count; ++i) {
    const auto edits = edits_of(*trace, *noise, options.seed + static_cast<std::uint64_t>(i));
    auto varied = edited_trace(*trace, edits);
    const auto path =
        (fs::path(options.output) / fmt::format("{}.{:0{}}{}", trace_name(options.trace), i + 1, digits, trace_ending))
            .string();
    if (auto unwritten = write_moved(varied, options.trace, path, options.knowledge)) return unwritten;
    fmt::print("{} -> {}\n", counted(edits.size(), "change"), printable_line(path));
    if (!options.changes) continue;
    for (const auto& edit : edits) fmt::print("  {}\n", printable_line(edit.sentence));
  }
  return std::nullopt;
}

}  // namespace

int run_vary(const VaryOptions& options) {
  if (const auto problem = vary(options)) return report(*problem), exit_impossible;
  return exit_done;
}

void describe_vary(CLI::App& command, VaryOptions& options) {
  command.add_option("TRACE", options.trace, "a trace (.jsonl, .jsonl.gz)")->required();
  command.add_option(
      "--with", options.noise,
      "how much goes wrong: a JSON file (replay/noise/NOISE.md), or a name in knowledge/noise; otherwise "
      "standard: a fifth of the words, and some of everything else");
  command.add_option("--count", options.count, "how many traces")->check(CLI::Range(1, 1'000'000));
  command.add_option("-o,--output", options.output, "a folder for NAME.1.trace.jsonl, NAME.2.trace.jsonl, …")
      ->required();
  command.add_option("--seed", options.seed, "of the first trace, otherwise 0; each further one has the next");
  command.add_flag("--changes", options.changes, "tell each change");
  command.add_option("--knowledge", options.knowledge, "folder with noise and confusions; otherwise the program's");
  command.footer(
      "Words are dropped, swapped and misheard as a recogniser mishears them, utterances become n-best lists, times "
      "are "
      "jittered, gestures are missed or seen twice, pointing is off, late or cut. `expect` lines are left out: they "
      "told of the whole trace. The same seed gives the same traces.\n"
      "Examples: continua vary session.trace.jsonl --count 100 -o varied\n"
      "          continua vary session.trace.jsonl --with noise.json --seed 7 --changes -o varied");
}

}  // namespace continua
