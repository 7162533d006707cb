#include "machine_file/machine_loader.h"

#include "machine_file/jflap.h"
#include "machine_file/machine_reader.h"

namespace continua {

Result<Machine> parse_machine(std::string_view text, const std::string& name, const Signature& methods,
                              const std::string& phrases) {
  auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  MachineReader reader(*document, methods, phrases);
  auto machine = reader.read();
  if (auto problems = reader.problems(); !problems.empty()) return problems.front();
  return machine;
}

Result<Machine> load_machine(const std::string& path, const Signature& methods, const std::string& phrases) {
  auto text = read_file(path);
  if (!text) return text.error();
  if (!is_jflap(*text, path)) return parse_machine(*text, path, methods, phrases);
  const auto machine = machine_of_jflap(*text, path);
  if (!machine) return machine.error();
  return parse_machine(compact(*machine), path, methods, phrases);
}

std::vector<Error> check_machine(std::string_view text, const std::string& name, const Signature& methods,
                                 const std::string& phrases) {
  auto document = LocatedJson::parse(text, name);
  if (!document) return {document.error()};
  MachineReader reader(*document, methods, phrases);
  reader.read();
  return reader.problems();
}

}  // namespace continua
