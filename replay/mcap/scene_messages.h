// The scene of a run as messages of Foxglove: each body once, in a frame of its own, and the frames over time.
#pragma once

#include "continua/core/located_json.h"
#include "continua/core/sim_time.h"
#include "continua/replay/scene/run_poses.h"

namespace continua {

/// {"sec", "nsec"}.
Json foxglove_time(SimTime t);

/// foxglove.SceneUpdate of the geoms of run_scene(): an entity for each body, in the frame of its name.
Json scene_update_of(const Json& scene);

/// foxglove.FrameTransforms of bodies in the frame "world".
Json frame_transforms_of(SimTime t, const BodyPoses& bodies);

}  // namespace continua
