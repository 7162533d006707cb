// The parts of an engine that come from knowledge files: a machine, its language, and its way to decide.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "continua/automaton/choice.h"
#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/knowledge_shelf.h"
#include "continua/moves/understanding.h"
#include "continua/world/perspective.h"

namespace continua {

struct EngineParts {
  std::shared_ptr<const Machine> machine;
  std::shared_ptr<const Language> language;
  Choice choice = Choice::likeliest;
  Perspective perspective = Perspective::human;  ///< whose left "left" is, if the words leave that open
  std::uint64_t seed = 0;                        ///< of the generator, for draws under `sample` and random facts
  std::map<int, std::size_t> forced;             ///< step → transition
  std::shared_ptr<OutsidePolicy> outside;        ///< decides in place of `choice`; null: none
  std::string choice_told;                       ///< that policy's name, for logs
  Json knowledge;                                ///< digests of the files (knowledge_digests)

  /// The chooser for a run that begins with these parts.
  Chooser chooser() const { return {choice, Random(seed), forced, 0, outside}; }
};

/// The parts for a loaded machine: its language from `data`, or from the shelf if that has it; its own choice and
/// perspective. The error is the first problem of a file.
Result<EngineParts> load_engine_parts(std::shared_ptr<const Machine> machine, const DataPaths& data,
                                      KnowledgeShelf& shelf);

/// The parts for a machine by its name or path (resolve_machine()), in `language` unless that is empty.
Result<EngineParts> load_engine_parts(const std::string& machine, const DataPaths& data,
                                      const std::string& language = "");

}  // namespace continua
