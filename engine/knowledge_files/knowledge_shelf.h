// Knowledge that is read once for many runs.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/moves/understanding.h"

namespace continua {

/// Reads machines and languages as language_loading.h does, each of them once: whoever asks again gets what was read,
/// so the files must not change meanwhile. Errors are not kept. Any number of threads may ask at once.
class KnowledgeShelf {
 public:
  Result<std::shared_ptr<const Machine>> machine(const std::string& path, const DataPaths& data,
                                                 const std::string& language, const std::string& where);
  Result<std::shared_ptr<const Language>> language(const DataPaths& data, const Machine& machine);
  /// The digests of the files of that machine's language.
  Json digests(const DataPaths& data, const Machine& machine, const Language& language);

 private:
  std::mutex mutex_;
  /// By path and by language with its data.
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const Machine>> machines_;
  std::map<std::string, std::shared_ptr<const Language>> languages_;
  std::map<std::string, Json> digests_;
};

}  // namespace continua
