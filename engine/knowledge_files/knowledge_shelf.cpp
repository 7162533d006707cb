#include "continua/knowledge_files/knowledge_shelf.h"

#include "continua/knowledge_files/language_loading.h"

namespace continua {
namespace {

// All that a language depends on, with a separator that no name contains.
std::string key_of(const DataPaths& data, const Machine& machine) {
  return data.knowledge.string() + '\n' + machine.lexicon + '\n' + machine.gestures;
}

}  // namespace

Result<std::shared_ptr<const Machine>> KnowledgeShelf::machine(const std::string& path, const DataPaths& data,
                                                               const std::string& language, const std::string& where) {
  const std::lock_guard lock(mutex_);
  const std::pair key(path, data.knowledge.string() + '\n' + language);
  if (const auto known = machines_.find(key); known != machines_.end()) return known->second;
  auto machine = load_machine(path, data, language, where);
  if (!machine) return machine.error();
  return machines_.emplace(key, std::make_shared<const Machine>(*std::move(machine))).first->second;
}

Result<std::shared_ptr<const Language>> KnowledgeShelf::language(const DataPaths& data, const Machine& machine) {
  const std::lock_guard lock(mutex_);
  const auto key = key_of(data, machine);
  if (const auto known = languages_.find(key); known != languages_.end()) return known->second;
  auto language = load_language(data, machine);
  if (!language) return language.error();
  return languages_.emplace(key, std::make_shared<const Language>(*std::move(language))).first->second;
}

Json KnowledgeShelf::digests(const DataPaths& data, const Machine& machine, const Language& language) {
  const std::lock_guard lock(mutex_);
  const auto key = key_of(data, machine);
  const auto known = digests_.find(key);
  return known != digests_.end() ? known->second
                                 : digests_.emplace(key, knowledge_digests(data, machine, language)).first->second;
}

}  // namespace continua
