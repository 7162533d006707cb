#include "continua/replay/commands/explain.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "continua/replay/commands/instant_option.h"
#include "continua/replay/explain/explain_text.h"
#include "continua/replay/explain/run_account.h"

namespace continua {
namespace {

constexpr std::size_t narrowest = 40;  // columns: below, lines are let go over the edge

ExplainTextOptions text_options(bool all) {
  ExplainTextOptions options;
  options.all = all;
  if (isatty(STDOUT_FILENO) == 0) return options;
  struct winsize size {};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    options.width = std::max<std::size_t>(size.ws_col, narrowest);
  options.colour = std::getenv("NO_COLOR") == nullptr;
  return options;
}

}  // namespace

int run_explain(const ExplainOptions& options) {
  const auto run = RunIndex::open(options.run);
  if (!run) return report(run.error()), exit_impossible;
  const auto n = asked_record(*run, options.question);
  if (!n) return report(n.error()), exit_impossible;
  const auto explained = explain(*run, *n);
  if (!explained) return report(explained.error()), exit_impossible;
  auto text = options.json   ? explained->dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
              : options.tree ? printable(explain_tree(*explained, text_options(options.all)))
                             : printable(explain_text(*explained, text_options(options.all)));
  const auto& [at_s, step, act, record] = options.question;
  if (!options.json && !options.tree && !at_s && !step && !act && !record) {
    const auto account = run_account(*run);
    if (!account) return report(account.error()), exit_impossible;
    text = printable(account_text(*account, text_options(options.all).width)) + "\n" + text;
  }
  if (options.tree && text.empty()) return report({run->where(*n), "no term is behind this record"}), exit_no;
  if (const auto problem = write_file("-", text)) return report(*problem), exit_impossible;
  return exit_done;
}

void describe_explain(CLI::App& command, ExplainOptions& options) {
  command.add_option("RUN", options.run, "a run log (.run.jsonl, .run.jsonl.gz)")->required();
  auto* asked = command.add_option_group(
      "what is asked about",
      "without any: the run in a few sentences, then an unmet expectation, the first question or the last act");
  takes_instants(
      asked->add_option("--at", options.question.at_s, "the last that the avatar did or refused until then"));
  asked->add_option("--step", options.question.step, "the transition of this number, and what it brought about");
  asked->add_option("--act", options.question.act, "the act of this number");
  asked->add_option("--record", options.question.record, "the record of this number (#n)");
  asked->require_option(0, 1);
  auto* json = command.add_flag("--json", options.json, "one JSON document");
  command.add_flag("--tree", options.tree, "the derivation alone, as a term tree")->excludes(json);
  command.add_flag("--all", options.all, "every refused transition, input and symbol");
  command.footer(
      "Examples: continua explain talk.run.jsonl\n"
      "          continua explain talk.run.jsonl --at 12.5\n"
      "          continua explain talk.run.jsonl --act 1 --tree");
}

}  // namespace continua
