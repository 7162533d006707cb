#include "continua/replay/session/shelf.h"

#include <utility>

#include "continua/core/digest.h"
#include "continua/replay/recorder/machine_graph.h"

namespace continua {
namespace {

constexpr std::size_t most_held = 32;  // scenes; and machines

}  // namespace

Result<Scene> Shelf::scene(const std::string& name, const std::function<Result<Scene>()>& load) {
  const std::lock_guard lock(mutex_);
  if (const auto found = scenes_.find(name); found != scenes_.end()) return found->second;
  auto scene = load();
  if (!scene) return scene;
  if (scenes_.size() == most_held) scenes_.clear();
  scenes_.emplace(name, *scene);
  return scene;
}

std::shared_ptr<const MachineInHeader> Shelf::in_header(const std::shared_ptr<const Machine>& machine) {
  const std::lock_guard lock(mutex_);
  if (const auto found = in_headers_.find(machine); found != in_headers_.end()) return found->second;
  if (in_headers_.size() == most_held) in_headers_.clear();
  auto told = std::make_shared<const MachineInHeader>(
      MachineInHeader{digest(machine->document), digest(machine->phrase_document), graph_of(*machine)});
  return in_headers_.emplace(machine, std::move(told)).first->second;
}

}  // namespace continua
