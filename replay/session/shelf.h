// Knowledge and scenes that several runs have in common.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "continua/core/result.h"
#include "continua/knowledge_files/knowledge_shelf.h"
#include "continua/simulation/scene.h"

namespace continua {

/// Each of them is read once, so the files must not change meanwhile. Any number of threads may ask at once.
class Shelf {
 public:
  KnowledgeShelf& knowledge() { return knowledge_; }

  /// The scene of that name, loaded when it is asked for first. Only so many are held as a batch of traces is likely to
  /// share. Errors are those of `load`; they are not kept.
  Result<Scene> scene(const std::string& name, const std::function<Result<Scene>()>& load);

 private:
  KnowledgeShelf knowledge_;
  std::mutex mutex_;
  std::map<std::string, Scene> scenes_;
};

}  // namespace continua
