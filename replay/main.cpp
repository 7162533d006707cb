// The program `continua`: reads its arguments and calls the command they name.
#include <malloc.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <array>
#include <exception>
#include <string>
#include <vector>

#include "core/located_json.h"
#include "replay/commands/accept.h"
#include "replay/commands/check.h"
#include "replay/commands/command.h"
#include "replay/commands/coverage.h"
#include "replay/commands/diff.h"
#include "replay/commands/explain.h"
#include "replay/commands/export.h"
#include "replay/commands/import.h"
#include "replay/commands/machine.h"
#include "replay/commands/record.h"
#include "replay/commands/render.h"
#include "replay/commands/replay.h"
#include "replay/commands/score.h"
#include "replay/commands/serve.h"
#include "replay/commands/shrink.h"
#include "replay/commands/validate.h"
#include "replay/session/version.h"

namespace continua {
namespace {

constexpr std::array commands = {
    add_replay_command,   add_record_command, add_explain_command, add_diff_command,   add_serve_command,
    add_render_command,   add_export_command, add_machine_command, add_import_command, add_check_command,
    add_coverage_command, add_score_command,  add_shrink_command,  add_accept_command, add_validate_command,
};

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// What is wrong with the arguments, in one sentence.
std::string sentence_of(const CLI::App& program, const CLI::ParseError& problem) {
  const auto chosen = program.get_subcommands();
  const CLI::App& command = chosen.empty() ? program : *chosen.front();
  const auto help = chosen.empty() ? "continua --help" : "continua " + command.get_name() + " --help";
  const auto not_understood = program.remaining(true);
  if (not_understood.empty()) return fmt::format("{} (see {})", problem.what(), help);

  const auto& first = not_understood.front();
  if (first.starts_with('-'))
    return fmt::format("there is no option {}{} (see {})", in_quotes(first), did_you_mean(first, options_of(command)),
                       help);
  if (!chosen.empty()) return fmt::format("found {}; expected no more arguments (see {})", in_quotes(first), help);
  std::vector<std::string> names;
  for (const auto* known : program.get_subcommands({})) names.push_back(known->get_name());
  return fmt::format("there is no command {}{}; expected one of {}", in_quotes(first), did_you_mean(first, names),
                     fmt::join(names, ", "));
}

int run_program(int argc, char** argv) {
  CLI::App program("Replays recorded conversations between a human and an avatar, and tells what it understood.",
                   "continua");
  program.require_subcommand(1);
  program.set_version_flag("--version", version_text());
  program.footer(
      "Exit status: 0 done, 1 the answer is no, 2 it could not be done.\n"
      "'continua COMMAND --help' describes a command.");
  Run run;
  for (const auto add : commands) add(program, run);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return program.exit(asked);
  } catch (const CLI::ParseError& problem) {
    report({"", sentence_of(program, problem)});
    return exit_impossible;
  }
  return run();
}

}  // namespace
}  // namespace continua

int main(int argc, char** argv) {
  // Live sessions have threads of their own; a heap for each would be kept when they are gone.
  ::mallopt(M_ARENA_MAX, 2);
  try {
    return continua::run_program(argc, argv);
  } catch (const std::exception& problem) {  // out of memory, a file system that fails in mid-walk
    continua::report({"", problem.what()});
    return continua::exit_impossible;
  }
}
