#include "continua/replay/commands/diff.h"

#include <unistd.h>

#include <cstdlib>
#include <future>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/experiment/trace_diff.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/log_file.h"

namespace continua {
namespace {

// "trace" or "run", as the first line says; empty for anything else.
std::string kind_of(const std::string& path) {
  const auto line = first_line(path);
  std::string kind;
  if (!line) return kind;
  scan_members(without_byte_order_mark(*line), [&](std::string_view key, std::string_view value) {
    if (key == "kind" && value.size() >= 2) kind = value.substr(1, value.size() - 2);
  });
  return kind;
}

bool wants_colour() { return isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR"); }

void print_json(const Json& json) { fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace)); }

int runs(const DiffCommandOptions& options) {
  auto other = std::async(std::launch::async, [&] { return RunIndex::open(options.b); });
  const auto a = RunIndex::open(options.a);
  const auto b = other.get();
  if (!a) return report(a.error()), exit_impossible;
  if (!b) return report(b.error()), exit_impossible;
  const auto diff = diff_runs(*a, *b, {options.tolerance_m});
  if (!diff) return report(diff.error()), exit_impossible;
  if (options.json)
    print_json(diff_json(*a, *b, *diff));
  else
    fmt::print("{}", options.markdown ? diff_markdown(*a, *b, *diff)
                                      : printable(diff_text(*a, *b, *diff, {wants_colour(), options.most})));
  return is_same(*diff) ? exit_done : exit_no;
}

int traces(const DiffCommandOptions& options) {
  const auto a = read_trace(options.a), b = read_trace(options.b);
  if (!a) return report(a.error()), exit_impossible;
  if (!b) return report(b.error()), exit_impossible;
  const auto diff = diff_traces(*a, *b);
  if (options.json)
    print_json(trace_diff_json(diff));
  else
    fmt::print("{}", options.markdown ? trace_diff_markdown(diff) : trace_diff_text(diff, wants_colour()));
  return diff.same ? exit_done : exit_no;
}

}  // namespace

int run_diff_command(const DiffCommandOptions& options) {
  const auto kind_a = kind_of(options.a), kind_b = kind_of(options.b);
  if (kind_a == "trace" && kind_b == "trace") return traces(options);
  if ((kind_a == "trace" && kind_b == "run") || (kind_a == "run" && kind_b == "trace"))
    return report(
               {options.b, fmt::format("is a {}, and {} is a {}; expected two of a kind", kind_b, options.a, kind_a)}),
           exit_impossible;
  return runs(options);
}

void describe_diff(CLI::App& command, DiffCommandOptions& options) {
  command.add_option("A", options.a, "a run log, or a trace")->required();
  command.add_option("B", options.b, "another one of the same kind")->required();
  auto* json = command.add_flag("--json", options.json, "print all of it as one JSON document");
  command.add_flag("--markdown", options.markdown, "print it for a pull request, details folded")->excludes(json);
  command
      .add_option("--tolerance", options.tolerance_m,
                  "metres that a body may be elsewhere where all else is the same; 0.001 if left out")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--most", options.most, "how many differences to show beside the first; 10 if left out");
  command.footer(
      "Runs of different traces, machines, lexicons and worlds can be held against each other; numbers of records, "
      "ids\n"
      "and the times that shift with an input do not count. Exit status: 0 the same, 1 different, 2 it cannot be "
      "told.\n"
      "Example: continua diff before.run.jsonl after.run.jsonl");
}

}  // namespace continua
