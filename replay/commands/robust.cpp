#include "continua/replay/commands/robust.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "continua/core/several_at_once.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/commands/moved_paths.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/experiment/robust_text.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/terminal/progress.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// The noise without the kinds that are not wanted.
Result<Noise> wanted_noise(const RobustCommandOptions& options) {
  const auto data = find_data_paths(options.replay.knowledge);
  if (!data) return data.error();
  auto noise = read_noise(options.noise, data->knowledge);
  if (!noise || options.kinds.empty()) return noise;
  const auto leave_out = [&](const char* kind, auto& part) {
    if (std::find(options.kinds.begin(), options.kinds.end(), kind) == options.kinds.end()) part = {};
  };
  leave_out("words", noise->words);
  leave_out("n_best", noise->n_best);
  leave_out("times", noise->times);
  leave_out("gestures", noise->gestures);
  leave_out("pointing", noise->pointing);
  return noise;
}

// All traces, some at a time; the results in their order. The error is that of the first trace with one.
Result<Robustness> robustness_of_all(const RobustCommandOptions& options, const RobustOptions& trials) {
  std::vector<std::optional<Result<Robustness>>> found(options.traces.size());
  auto replay = options.replay;
  replay.shelf = std::make_shared<Shelf>();
  Progress progress(found.size());
  std::mutex showing;
  several_at_once(found.size(), options.jobs, [&](std::size_t i) {
    auto session = Session::load(options.traces[i], replay);
    found[i] = session ? robustness_of(*session, trials) : Result<Robustness>(session.error());
    const std::lock_guard lock(showing);
    progress.show(i, 1);
  });
  progress.clear();
  Robustness sum;
  for (auto& one : found) {
    if (!*one) return one->error();
    add(sum, std::move(**one));
  }
  return sum;
}

Outcome write_breaks(const RobustCommandOptions& options, const Robustness& robustness) {
  std::error_code problem;
  fs::create_directories(options.breaks, problem);
  if (problem) return Error{options.breaks, fmt::format("cannot be made a folder: {}", problem.message())};
  for (const auto& one : robustness.breaks) {
    const auto path =
        (fs::path(options.breaks) / fmt::format("{}.{}{}", trace_name(one.trace), one.kind, trace_ending)).string();
    if (auto unwritten = write_moved(one.with, one.trace, path, options.replay.knowledge)) return unwritten;
  }
  return std::nullopt;
}

}  // namespace

int run_robust(const RobustCommandOptions& options) {
  const auto fail = [](const Error& error) {
    report(error);
    return exit_impossible;
  };
  const auto noise = wanted_noise(options);
  if (!noise) return fail(noise.error());
  const auto robustness = robustness_of_all(options, {*noise, options.strengths, options.count, options.seed});
  if (!robustness) return fail(robustness.error());
  if (options.json)
    fmt::print("{}\n", compact(robust_json(*robustness)));
  else
    put(stdout, printable(robust_text(*robustness)));
  if (!options.output.empty())
    if (const auto problem = write_file(options.output, robust_svg(*robustness))) return fail(*problem);
  if (!options.breaks.empty())
    if (const auto problem = write_breaks(options, *robustness)) return fail(*problem);
  return robustness->breaks.empty() ? exit_done : exit_no;
}

void describe_robust(CLI::App& command, RobustCommandOptions& options) {
  options.replay.physics = false;
  command.add_option("TRACE", options.traces, "traces (.jsonl, .jsonl.gz)")->required();
  command.add_option("--with", options.noise,
                     "the noise of strength 1: a JSON file (replay/noise/NOISE.md), or a name in knowledge/noise; "
                     "otherwise standard");
  command
      .add_option(
          "--kind", options.kinds,
          fmt::format("kinds of noise, of {}; otherwise all that the noise has", fmt::join(noise_kinds(), ", ")))
      ->check(CLI::IsMember(noise_kinds()));
  command.add_option("--strength", options.strengths, "strengths; otherwise 0.25 0.5 1 2")
      ->check(CLI::Range(0.0, 100.0));
  command.add_option("--count", options.count, "runs of each trace for each kind and strength; otherwise 10")
      ->check(CLI::Range(1, 100'000));
  command.add_option("--seed", options.seed, "of the draws, together with each trace's text");
  command.add_option("-j,--jobs", options.jobs, "traces at a time")->check(CLI::Range(1, 1024));
  command.add_option("-o,--output", options.output, "a picture of the curves, SVG");
  command.add_option("--breaks", options.breaks,
                     "a folder for traces, NAME.KIND.trace.jsonl, each with a smallest change that makes its run do "
                     "something else");
  command.add_flag("--json", options.json, "the figures as JSON");
  command.add_flag("--physics,!--no-physics", options.replay.physics, "with physics; otherwise in the kinematic world");
  add_setting_options(command, options.replay);
  command.footer(
      "Each run is held against that without noise. same: the same acts; asks: the avatar says something else before "
      "it does anything else; less: acts are missing and nothing is said; otherwise: it does what it did not do "
      "before. "
      "After the table, for each trace and kind, the smallest change that made a run do something else, and what it "
      "did.\n"
      "Exit status: 1 if a run does something else.\n"
      "Examples: continua robust talk/*.trace.jsonl -o curves.svg\n"
      "          continua robust talk.trace.jsonl --kind words --strength 1 --count 100 --breaks breaks");
}

}  // namespace continua
