// continua complete: the words that may come next on a command line, for the completion of shells
// (ci/packaging/completions).
#pragma once

#include <string>
#include <vector>

#include "continua/replay/commands/command.h"

namespace continua {

struct CompleteOptions {
  const CLI::App* program = nullptr;  ///< with all its commands
  std::vector<std::string> words;     ///< of the line, after "continua"; the last is being typed, perhaps empty
};

/// A word that the last one may become, and its meaning; "" without one.
struct Completion {
  std::string word, meaning;
  auto operator<=>(const Completion&) const = default;
};

/// Commands, options, the values that an option names, machines, scenes, languages, and files of the wanted kind. A
/// folder ends in '/'.
std::vector<Completion> completions(const CLI::App& program, std::vector<std::string> words);

/// Prints a line for each: the word, a tab, its meaning.
int run_complete(const CompleteOptions& options);

void describe_complete(CLI::App& command, CompleteOptions& options);

}  // namespace continua
