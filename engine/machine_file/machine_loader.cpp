#include "continua/machine_file/machine_loader.h"

#include "continua/machine_file/jflap.h"
#include "continua/machine_file/machine_reader.h"

namespace continua {

Result<Machine> parse_machine(std::string_view text, const std::string& name, const Signature& facts,
                              const std::string& phrases, const std::string& language, const RaisingRules& raising) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  auto [machine, problems] = read_machine(*document, facts, phrases, language, raising);
  if (!problems.empty()) return problems.front();
  return std::move(machine);
}

Result<Machine> load_machine(const std::string& path, const Signature& facts, const std::string& phrases,
                             const std::string& language, const RaisingRules& raising) {
  auto text = read_file(path);
  if (!text) return text.error();
  if (!is_jflap(*text, path)) return parse_machine(*text, path, facts, phrases, language, raising);
  const auto machine = machine_of_jflap(*text, path);
  if (!machine) return machine.error();
  return parse_machine(compact(*machine), path, facts, phrases, language, raising);
}

std::vector<Error> check_machine(std::string_view text, const std::string& name, const Signature& facts,
                                 const std::string& phrases, const std::string& language, const RaisingRules& raising) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return {document.error()};
  return read_machine(*document, facts, phrases, language, raising).problems;
}

}  // namespace continua
