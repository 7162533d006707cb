// From a scene's file to MuJoCo's model: inclusions, what the scene tells of its avatar, and the weld of the hand.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/scene_source.h"

namespace continua {

struct CompiledScene {
  SceneSource source;  ///< complete: what was told, guessed and added is in its text
  std::shared_ptr<const mjModel> model;
  std::vector<std::string> guesses;  ///< about the avatar, "file:line: sentence"
};

/// Errors, with file and line if there is one: those of SceneSource::read and of with_told_avatar; MuJoCo refuses the
/// text; a time step that nobody can use; the hand has no name.
Result<CompiledScene> compile_scene(const std::string& path);

/// The compiled source, or an error with its place.
Result<std::shared_ptr<const mjModel>> compile(const SceneSource& source);

}  // namespace continua
