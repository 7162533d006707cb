#include "continua/knowledge_files/engine_parts.h"

#include <utility>

namespace continua {

Result<EngineParts> load_engine_parts(std::shared_ptr<const Machine> machine, const DataPaths& data,
                                      KnowledgeShelf& shelf) {
  auto language = shelf.language(data, *machine);
  if (!language) return language.error();
  EngineParts parts;
  parts.choice = machine->choice;
  if (machine->perspective == "avatar") parts.perspective = Perspective::avatar;
  parts.knowledge = shelf.digests(data, *machine, **language);
  parts.machine = std::move(machine);
  parts.language = *std::move(language);
  return parts;
}

Result<EngineParts> load_engine_parts(const std::string& machine, const DataPaths& data, const std::string& language) {
  const auto path = resolve_machine(machine, data, ".", "");
  if (!path) return path.error();
  KnowledgeShelf shelf;
  auto loaded = shelf.machine(*path, data, language, "");
  if (!loaded) return loaded.error();
  return load_engine_parts(*std::move(loaded), data, shelf);
}

}  // namespace continua
