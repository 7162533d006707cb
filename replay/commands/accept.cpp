#include "continua/replay/commands/accept.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <iterator>

#include "continua/analysis/acceptance.h"
#include "continua/core/characters.h"
#include "continua/core/located_json.h"
#include "continua/knowledge_files/named_machine.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_index.h"

namespace continua {
namespace {

Result<std::string> read_words(const std::string& path) {
  if (path != "-") return read_file(path);
  return std::string(std::istreambuf_iterator<char>(std::cin), {});
}

// A line each; an empty line is the empty word.
void append_lines(std::string_view text, std::vector<std::string>& words) {
  text = without_byte_order_mark(text);
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto line = text.substr(0, end);
    words.emplace_back(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::vector<std::string> between_spaces(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find(' ', at), text.size());
    if (end > at) parts.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

}  // namespace

std::vector<std::string> symbols_of_word(std::string_view word) {
  return word.find(' ') == std::string_view::npos ? characters(word) : between_spaces(word);
}

Result<std::string> moves_of_run(const std::string& path, const Machine& machine) {
  const auto run = RunIndex::open(path);
  if (!run) return run.error();
  std::string moves;
  for (const auto n : run->of_kind(log::Reading::kind.name)) {
    const auto record = run->record(n);
    if (!record) return record.error();
    const auto move = record->value("move", Json());
    if (!move.is_string() || !machine.knows_input(move.get<std::string>())) continue;
    if (!moves.empty()) moves += ' ';
    moves += move.get<std::string>();
  }
  return moves;
}

int run_accept(const AcceptOptions& options) {
  auto words = options.words;
  if (!options.words_file.empty()) {
    const auto text = read_words(options.words_file);
    if (!text) return report(text.error()), exit_impossible;
    append_lines(*text, words);
  } else if (words.empty() && options.runs.empty()) {
    return report({"", "found no word; expected WORD, --words or --run (see continua accept --help)"}), exit_impossible;
  }
  const auto machine = load_named_machine(options.machine);
  if (!machine) return report(machine.error()), exit_impossible;
  Acceptance acceptance(*machine, options.empty_stack ? AcceptBy::empty_stack : AcceptBy::final_state);
  int status = exit_done;
  const auto judge = [&](const std::vector<std::string>& word, const std::string& remark) -> Outcome {
    const auto verdict = acceptance.accepts(word);
    if (!verdict) return Error{options.machine, verdict.error().text()};
    // At once: the next word may take a while.
    if (const auto problem = write_file("-", (*verdict ? "accept" : "reject") + remark + "\n")) return *problem;
    if (!*verdict) status = exit_no;
    return std::nullopt;
  };
  for (const auto& word : words)
    if (const auto problem = judge(symbols_of_word(word), "")) return report(*problem), exit_impossible;
  for (const auto& run : options.runs) {
    const auto moves = moves_of_run(run, **machine);
    if (!moves) return report(moves.error()), exit_impossible;
    if (const auto problem = judge(between_spaces(*moves), fmt::format(" {}: {}", run, *moves)))
      return report(*problem), exit_impossible;
  }
  return status;
}

void describe_accept(CLI::App& command, AcceptOptions& options) {
  command
      .add_option("MACHINE", options.machine,
                  "a name of the knowledge folder, or a path; also JFLAP's .jff of type fa or pda")
      ->required();
  command.add_flag("--empty-stack", options.empty_stack, "accept by empty stack instead of by final state");
  command.add_option("--run", options.runs, "run logs; the moves of each are a word")
      ->type_name("RUN")
      ->allow_extra_args(false);
  command.add_option("--words", options.words_file, "a file with a word a line; '-' is standard input");

  // A word that begins with '-' looks like an option. So that all words stay in order, WORD takes none of them: they
  // are the remaining arguments. WORD counts as still missing; without that '--' would end the command.
  command
      .add_option("WORD", options.words, "input symbols between spaces, or each character one; '' is the empty word")
      ->check([](const std::string&) { return std::string("remains"); });
  command.validate_positionals();
  command.allow_extras();

  command.footer(
      "Prints accept or reject for each word, in a line of its own. Exit status: 0 all accepted, 1 not all.\n"
      "What begins with '-' and is no option is a word; after '--' everything is.\n"
      "--run leaves out moves that the machine does not know.\n"
      "Example: continua accept palindromes abba ab ''\n"
      "         continua accept table_1 --run talk.run.jsonl");
  command.callback([&command, &options] {
    options.words = command.remaining();
    const auto mark = std::find(options.words.begin(), options.words.end(), "--");
    if (mark != options.words.end()) options.words.erase(mark);
  });
}

}  // namespace continua
