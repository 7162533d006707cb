#include "continua/knowledge_files/engine_parts.h"

#include <utility>

#include "continua/knowledge_files/language_loading.h"

namespace continua {

Result<EngineParts> load_engine_parts(Machine machine, const DataPaths& data) {
  auto language = load_language(data, machine);
  if (!language) return language.error();
  EngineParts parts;
  parts.choice = machine.choice;
  if (machine.perspective == "avatar") parts.perspective = Perspective::avatar;
  parts.knowledge = knowledge_digests(data, machine);
  parts.machine = std::make_shared<const Machine>(std::move(machine));
  parts.language = std::make_shared<const Language>(std::move(*language));
  return parts;
}

Result<EngineParts> load_engine_parts(const std::string& machine, const DataPaths& data, const std::string& language) {
  const auto path = resolve_machine(machine, data, ".", "");
  if (!path) return path.error();
  auto loaded = load_machine(*path, data, language);
  if (!loaded) return loaded.error();
  return load_engine_parts(*std::move(loaded), data);
}

}  // namespace continua
