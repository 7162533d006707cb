// continua accept: the classical question, which words a machine accepts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/replay/commands/command.h"

namespace continua {

struct AcceptOptions {
  std::string machine;
  std::vector<std::string> words;
  std::string words_file;  ///< a word a line; "-" is standard input; empty: none
  bool empty_stack = false;
  std::vector<std::string> runs = {};  ///< run logs: the moves of each are a word
};

/// The symbols of a word: its parts between spaces if it has any, else its characters.
std::vector<std::string> symbols_of_word(std::string_view word);

/// The moves of a run's `reading` records that the machine knows, in their order, separated by spaces.
Result<std::string> moves_of_run(const std::string& path, const Machine& machine);

/// "accept" or "reject" for each word on standard output, first those given, then those of the file, then those of the
/// runs, which are told too. exit_done if all
/// are accepted, exit_no if one is not, exit_impossible if the question cannot be answered.
int run_accept(const AcceptOptions& options);

void describe_accept(CLI::App& command, AcceptOptions& options);

}  // namespace continua
