// An avatar that the scene tells of, so that the file of an arm is included as others wrote it:
//   <custom> <text name="avatar" data="hand=… pads=…,… grip=… home=… base=…"/> </custom>
// mjcf/README.md has the words. Elements that are not told are guessed from the model.
#pragma once

#include <string>
#include <vector>

#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/scene_source.h"

namespace continua {

struct ToldAvatar {
  SceneSource source;                ///< with the elements that an arm must have, in place of the text
  std::vector<std::string> guesses;  ///< "file:line: sentence", for each element that was guessed
};

/// The source with what its text `avatar` tells; unchanged without that text. `model`: the source, compiled. Errors: a
/// word is unknown, names nothing of the model, or is missing and cannot be guessed.
Result<ToldAvatar> with_told_avatar(const SceneSource& source, const mjModel& model);

}  // namespace continua
