// Pictures of runs on demand; those asked for last are kept.
#pragma once

#include <memory>

#include "continua/replay/scene/run_frames.h"

namespace continua {

/// Draws the scene with where people point, without text.
std::shared_ptr<RunFrames> drawn_frames();

}  // namespace continua
