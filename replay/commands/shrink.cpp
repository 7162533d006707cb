#include "continua/replay/commands/shrink.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/check/run_approved.h"
#include "continua/replay/commands/moved_paths.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/experiment/shrink.h"
#include "continua/replay/trace/trace_name.h"
#include "continua/simulation/mujoco_version.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// Overwrites its line on a terminal.
class Counter {
 public:
  void show(std::size_t events, std::size_t probes) {
    if (!on_terminal_ || probes % 8 != 0) return;
    put(stderr,
        fmt::format("\r{:<60}", fmt::format("{} left, {}", counted(events, "event"), counted(probes, "probe"))));
    std::fflush(stderr);
    shown_ = true;
  }
  void clear() const {
    if (shown_) put(stderr, fmt::format("\r{:60}\r", ""));
  }

 private:
  const bool on_terminal_ = isatty(STDERR_FILENO) != 0;
  bool shown_ = false;
};

}  // namespace

int run_shrink(const ShrinkCommandOptions& options) {
  const auto fail = [](const Error& error) {
    report(error);
    return exit_impossible;
  };
  const auto output = options.output.empty() ? trace_name(options.trace) + ".shrunk.trace.jsonl" : options.output;
  const auto goal = parse_goal(options.until);
  if (!goal) return fail(goal.error());
  auto session = Session::load(options.trace, options.replay);
  if (!session) return fail(session.error());
  auto inputs = session->files();
  inputs.push_back(options.against);
  if (const auto problem = not_an_input({output}, inputs)) return fail(*problem);

  auto against = options.against;
  if (goal->kind == "changed" && against.empty()) {
    const auto approved =
        find_approved_run(options.trace, options.replay.physics ? "physics" : "kinematic", mujoco_version());
    if (!approved) return fail(approved.error());
    if (!*approved)
      return fail({options.trace, "has no approved run beside it; expected one, or --against RUN or TRACE"});
    against = (*approved)->path;
  }

  const auto start = std::chrono::steady_clock::now();
  Counter counter;
  const auto show = [&](std::size_t events, std::size_t probes) { counter.show(events, probes); };
  auto shrunk = shrink(*session, *goal, show, against);
  counter.clear();
  if (!shrunk) return fail(shrunk.error());
  if (!shrunk->done) {
    report({options.trace, fmt::format("the whole trace never does {}: {}", in_quotes(goal->text), shrunk->instead)});
    return exit_no;
  }
  if (const auto problem = write_moved(shrunk->trace, options.trace, output, options.replay.knowledge))
    return fail(*problem);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  fmt::print(output == "-" ? stderr : stdout, "{}: {} -> {}, {}, {:.2f} s -> {}\n",
             printable_line(fs::path(options.trace).filename().string()), counted(shrunk->events_before, "event"),
             shrunk->events, counted(shrunk->probes, "probe"), passed.count(), printable_line(output));
  return exit_done;
}

void describe_shrink(CLI::App& command, ShrinkCommandOptions& options) {
  options.replay.physics = false;
  command.add_option("TRACE", options.trace, "a trace (.jsonl, .jsonl.gz)")->required();
  command
      .add_option(
          "--until", options.until,
          "what it must still do. A situation, met at some instant of the run, after an input or the end of an act: "
          "FIELD=VALUE with a field of an `expect` line (state, says, indicated, referents, act, holding, "
          "stack_depth), or JSON; given several times, all of it at one instant. Or unmet, refusal, problem: an "
          "`expect` line that is not met and finds the same, the same input refused in the same state, the same "
          "problem; the first one of the run, or :LINE, that of a line of the trace. Or changed: the run differs from "
          "another one with the same cause, as diff tells it")
      ->required()
      ->allow_extra_args(false);
  command.add_option("--against", options.against,
                     "with --until changed: a run log, or a trace; otherwise the approved run beside the trace. Where "
                     "that had another machine, each smaller trace is replayed with both");
  command.add_option("-o,--output", options.output, "a trace, or '-'; otherwise NAME.shrunk.trace.jsonl here");
  command.add_flag("--physics,!--no-physics", options.replay.physics,
                   "with physics; otherwise in the kinematic world, in which acts succeed at once");
  add_setting_options(command, options.replay);
  command.add_option("--learned", options.replay.learned, "a file of what was taught; it is not written");
  command.add_option("--seed", options.replay.seed, "for draws; otherwise the trace's");
  command.footer(
      "Takes away events by delta debugging, until taking away any single one would lose it, then alternatives of "
      "n-best lists, words, and objects of the header. `expect` lines that hold in the smaller run are kept.\n"
      "Examples: continua shrink session.trace.jsonl --until state=Ask\n"
      "          continua shrink session.trace.jsonl --until says=\"What should I put there?\" -o ask.trace.jsonl\n"
      "          continua shrink session.trace.jsonl --until '{\"state\":\"Ask\",\"stack_depth\":3}' -o -\n"
      "          continua shrink session.trace.jsonl --until unmet:14\n"
      "          continua shrink session.trace.jsonl --until changed --machine edited.json");
}

}  // namespace continua
