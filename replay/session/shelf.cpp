#include "continua/replay/session/shelf.h"

namespace continua {
namespace {

constexpr std::size_t most_scenes = 32;

}  // namespace

Result<Scene> Shelf::scene(const std::string& name, const std::function<Result<Scene>()>& load) {
  const std::lock_guard lock(mutex_);
  if (const auto found = scenes_.find(name); found != scenes_.end()) return found->second;
  auto scene = load();
  if (!scene) return scene;
  if (scenes_.size() == most_scenes) scenes_.clear();
  scenes_.emplace(name, *scene);
  return scene;
}

}  // namespace continua
