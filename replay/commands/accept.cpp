#include "replay/commands/accept.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <iterator>

#include "analysis/acceptance.h"
#include "core/characters.h"
#include "core/located_json.h"
#include "replay/commands/named_machine.h"

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

}  // namespace

std::vector<std::string> symbols_of_word(std::string_view word) {
  if (word.find(' ') == std::string_view::npos) return characters(word);
  std::vector<std::string> symbols;
  for (std::size_t at = 0; at < word.size();) {
    const auto end = std::min(word.find(' ', at), word.size());
    if (end > at) symbols.emplace_back(word.substr(at, end - at));
    at = end + 1;
  }
  return symbols;
}

int run_accept(const AcceptOptions& options) {
  auto words = options.words;
  if (!options.words_file.empty()) {
    const auto text = read_words(options.words_file);
    if (!text) return report(text.error()), exit_impossible;
    append_lines(*text, words);
  } else if (words.empty()) {
    return report({"", "found no word; expected WORD or --words (see continua accept --help)"}), exit_impossible;
  }
  const auto machine = load_named_machine(options.machine);
  if (!machine) return report(machine.error()), exit_impossible;
  Acceptance acceptance(*machine, options.empty_stack ? AcceptBy::empty_stack : AcceptBy::final_state);
  std::string verdicts;
  int status = exit_done;
  for (const auto& word : words) {
    const auto verdict = acceptance.accepts(symbols_of_word(word));
    if (!verdict) return report({options.machine, verdict.error().text()}), exit_impossible;
    verdicts += *verdict ? "accept\n" : "reject\n";
    if (!*verdict) status = exit_no;
  }
  if (const auto problem = write_file("-", verdicts)) return report(*problem), exit_impossible;
  return status;
}

void add_accept_command(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("accept", "Tell which words a machine accepts");
  auto options = std::make_shared<AcceptOptions>();
  command
      ->add_option("MACHINE", options->machine,
                   "a name of the knowledge folder, or a path; also JFLAP's .jff of type fa or pda")
      ->required();
  command->add_flag("--empty-stack", options->empty_stack, "accept by empty stack instead of by final state");
  command->add_option("--words", options->words_file, "a file with a word a line; '-' is standard input");

  // A word that begins with '-' looks like an option. So that all words stay in order, WORD takes none of them: they
  // are what remains. It counts as still missing, without which '--' would end the command.
  command
      ->add_option("WORD", options->words, "input symbols between spaces, or each character one; '' is the empty word")
      ->check([](const std::string&) { return std::string("remains"); });
  command->validate_positionals();
  command->allow_extras();

  command->footer(
      "Prints accept or reject for each word, in a line of its own. Exit status: 0 all accepted, 1 not all.\n"
      "What begins with '-' and is no option is a word; after '--' everything is.\n"
      "Example: continua accept palindromes abba ab ''");
  command->callback([command, options, &run] {
    options->words = command->remaining();
    const auto mark = std::find(options->words.begin(), options->words.end(), "--");
    if (mark != options->words.end()) options->words.erase(mark);
    run = [options] { return run_accept(*options); };
  });
}

}  // namespace continua
