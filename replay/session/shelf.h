// Knowledge and scenes that several runs have in common.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "continua/core/result.h"
#include "continua/knowledge_files/knowledge_shelf.h"
#include "continua/replay/log/records.h"
#include "continua/simulation/scene.h"

namespace continua {

/// The parts of a run log's header that follow from a machine alone.
struct MachineInHeader {
  std::string digest, phrase_digest;  ///< of its document and of its phrases
  log::Graph graph;
};

/// Each of them is read once, so the files must not change meanwhile. Any number of threads may ask at once.
class Shelf {
 public:
  KnowledgeShelf& knowledge() { return knowledge_; }

  /// The scene of that name, loaded when it is asked for first. Only so many are held as a batch of traces is likely to
  /// share. Errors are those of `load`; they are not kept.
  Result<Scene> scene(const std::string& name, const std::function<Result<Scene>()>& load);

  /// Computed when it is asked for first, and held as scenes are.
  std::shared_ptr<const MachineInHeader> in_header(const std::shared_ptr<const Machine>& machine);

 private:
  KnowledgeShelf knowledge_;
  std::mutex mutex_;
  std::map<std::string, Scene> scenes_;
  /// With the machines held, so that none of them gives its address to another one.
  std::map<std::shared_ptr<const Machine>, std::shared_ptr<const MachineInHeader>> in_headers_;
};

}  // namespace continua
