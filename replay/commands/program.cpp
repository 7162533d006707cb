#include "continua/replay/commands/program.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/commands/accept.h"
#include "continua/replay/commands/check.h"
#include "continua/replay/commands/command.h"
#include "continua/replay/commands/complete.h"
#include "continua/replay/commands/coverage.h"
#include "continua/replay/commands/diff.h"
#include "continua/replay/commands/doctor.h"
#include "continua/replay/commands/explain.h"
#include "continua/replay/commands/explore_traces.h"
#include "continua/replay/commands/export.h"
#include "continua/replay/commands/import.h"
#include "continua/replay/commands/learn.h"
#include "continua/replay/commands/listen.h"
#include "continua/replay/commands/machine.h"
#include "continua/replay/commands/new.h"
#include "continua/replay/commands/pack.h"
#include "continua/replay/commands/record.h"
#include "continua/replay/commands/render.h"
#include "continua/replay/commands/replay.h"
#include "continua/replay/commands/robust.h"
#include "continua/replay/commands/score.h"
#include "continua/replay/commands/serve.h"
#include "continua/replay/commands/shrink.h"
#include "continua/replay/commands/sweep.h"
#include "continua/replay/commands/table.h"
#include "continua/replay/commands/trace.h"
#include "continua/replay/commands/validate.h"
#include "continua/replay/commands/vary.h"
#include "continua/replay/session/version.h"
#include "continua/replay/terminal/standard_input.h"

namespace continua {
namespace {

// A file by the name "-" is standard input.
void let_read_standard_input(CLI::App& command, const std::shared_ptr<StandardInput>& input) {
  for (auto* option : command.get_options())
    if (option->get_positional())
      option->transform(CLI::Validator(
          [input](std::string& name) {
            if (name != "-") return std::string();
            auto file = input->file();
            if (!file) return file.error().text();
            name = *std::move(file);
            return std::string();
          },
          ""));
  for (auto* more : command.get_subcommands({})) let_read_standard_input(*more, input);
}

struct Subcommand {
  CLI::App* described;
  std::function<int()> run;
};

template <class Options>
Subcommand add(CLI::App& program, const char* name, const char* purpose, void (*describe)(CLI::App&, Options&),
               int (*run)(const Options&)) {
  auto options = std::make_shared<Options>();
  auto* described = program.add_subcommand(name, purpose);
  describe(*described, *options);
  return {described, [options, run] { return run(*options); }};
}

// In the order of the help.
std::vector<Subcommand> add_all(CLI::App& program) {
  return {
      add(program, "replay", "Run traces through the engine and write their run logs", describe_replay, run_replay),
      add(program, "record", "Talk and point to the avatar, and keep the session", describe_record, run_record),
      add(program, "listen", "Turn a recogniser's output, as it comes, into events for record", describe_listen,
          run_listen),
      add(program, "explain", "Tell why a run went as it did at one of its records", describe_explain, run_explain),
      add(program, "diff", "Tell where two runs, or two traces, part and why", describe_diff, run_diff_command),
      add(program, "serve", "Show runs in a browser", describe_serve, run_serve),
      add(program, "render", "Draw pictures or a film of a run, without a display", describe_render, run_render),
      add(program, "export", "Write a run in another format", describe_export, run_export),
      add(program, "table", "Write the records of many runs as tables", describe_table, run_table),
      add(program, "pack", "Keep what run logs have in common once beside them, or put it back", describe_pack,
          run_pack),
      add(program, "machine", "Describe a machine, or draw it", describe_machine, run_machine),
      add(program, "import", "Turn session logs, annotations, MCAP files and outputs of recognisers into traces",
          describe_import, run_import),
      add(program, "trace", "Make traces of traces: cut, merge, shift, select, rename, anonymise", describe_trace,
          run_trace),
      add(program, "check",
          "Check what the project's files say of themselves, and hold traces against their approved runs",
          describe_check, run_check),
      add(program, "coverage", "Tell what of their machines and of the knowledge runs reach, and what never",
          describe_coverage, run_coverage),
      add(program, "score", "Replay traces and compare the avatar's moves with those that were observed",
          describe_score, run_score),
      add(program, "sweep", "Replay traces under many settings of their machine, and draw how they do", describe_sweep,
          run_sweep),
      add(program, "learn", "Estimate a machine's weights from traces with observed answers", describe_learn,
          run_learn),
      add(program, "shrink", "Find the smallest trace that still does something", describe_shrink, run_shrink),
      add(program, "vary", "Make traces as noisier recognisers would have told them", describe_vary, run_vary),
      add(program, "robust", "Tell how much noise conversations bear", describe_robust, run_robust),
      add(program, "explore-traces", "Look for conversations that go wrong", describe_explore_traces,
          run_explore_traces),
      add(program, "accept", "Tell which words a machine accepts", describe_accept, run_accept),
      add(program, "validate",
          "Check traces, machines, phrases, lexicons, voxemes, scenes, run logs, notes and session logs",
          describe_validate, run_validate),
      add(program, "new", "Make a folder to begin a project in", describe_new, run_new),
      add(program, "doctor", "Tell what of the program works on this machine", describe_doctor, run_doctor),
      add(program, "complete", "Tell a shell how a command line may go on", describe_complete, run_complete),
  };
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// The fault of the arguments, in one sentence.
std::string sentence_of(const CLI::App& program, const CLI::ParseError& problem) {
  const CLI::App* chosen = &program;
  std::string called = "continua";
  while (!chosen->get_subcommands().empty()) {
    chosen = chosen->get_subcommands().front();
    called += " " + chosen->get_name();
  }
  const CLI::App& command = *chosen;
  const auto help = called + " --help";
  const auto not_understood = program.remaining(true);
  if (not_understood.empty()) return fmt::format("{} (see {})", problem.what(), help);

  const auto& first = not_understood.front();
  if (first.starts_with('-'))
    return fmt::format("there is no option {}{} (see {})", in_quotes(first), did_you_mean(first, options_of(command)),
                       help);
  std::vector<std::string> names;
  for (const auto* known : command.get_subcommands({})) names.push_back(known->get_name());
  if (names.empty()) return fmt::format("found {}; expected no more arguments (see {})", in_quotes(first), help);
  return fmt::format("there is no command {}{}; expected one of {}", in_quotes(first), did_you_mean(first, names),
                     fmt::join(names, ", "));
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program("Replays recorded conversations between a human and an avatar, and tells what it understood.",
                   "continua");
  program.require_subcommand(1);
  program.set_version_flag("--version", version_text());
  program.footer(
      "Exit status: 0 done, 1 the answer is no, 2 it could not be done.\n"
      "'continua COMMAND --help' describes a command. A file by the name '-' is standard input.");
  const auto subcommands = add_all(program);
  let_read_standard_input(program, std::make_shared<StandardInput>());
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return program.exit(asked);
  } catch (const CLI::ParseError& problem) {
    report({"", sentence_of(program, problem)});
    return exit_impossible;
  }
  const auto chosen = std::find_if(subcommands.begin(), subcommands.end(),
                                   [](const Subcommand& one) { return one.described->parsed(); });
  return chosen->run();
}

}  // namespace continua
