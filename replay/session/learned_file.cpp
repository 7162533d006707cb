#include "continua/replay/session/learned_file.h"

#include <filesystem>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/knowledge_files/language_loading.h"
#include "continua/learning/learning_file.h"
#include "continua/pipeline/lessons.h"

namespace continua {
namespace fs = std::filesystem;

Result<Learned> read_learned(const std::string& path, const Machine& machine, const Language& language) {
  std::error_code unknown;
  if (!fs::exists(path, unknown)) return Learned();
  const auto text = read_file(path);
  if (!text) return text.error();
  auto names = names_of_terms();
  names.insert(machine.programs.begin(), machine.programs.end());
  if (language.lexicon) names.insert(language.lexicon->names.begin(), language.lexicon->names.end());
  auto learned = parse_learned(*text, path, names);
  if (!learned) return learned;
  for (const auto& [name, program] : learned->programs)
    if (is_taken(name, machine))
      return Error{path, fmt::format("found the word {}, which means something else in the machine {}", in_quotes(name),
                                     machine.name)};
  return learned;
}

Outcome write_learned(const std::string& path, const Learned& learned) {
  return replace_file(path, print_learned(learned));
}

}  // namespace continua
