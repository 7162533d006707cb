#include "continua/knowledge_files/named_machine.h"

#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/language_loading.h"

namespace continua {

Result<std::shared_ptr<const Machine>> load_named_machine(const std::string& name, const std::string& knowledge) {
  const auto data = find_data_paths(knowledge);
  if (!data) return data.error();
  const auto path = resolve_machine(name, *data, ".", "");
  if (!path) return path.error();
  auto machine = load_machine(*path, *data);
  if (!machine) return machine.error();
  return std::make_shared<const Machine>(*std::move(machine));
}

}  // namespace continua
