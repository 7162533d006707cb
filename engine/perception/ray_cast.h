// Where a pointing ray ends: at the first thing that it meets, else on the table's plane.
#pragma once

#include "continua/perception/input_event.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// The event with the place under the point where its ray first meets a thing's bounding box as target. An event
/// without a ray, with a target of its own, or whose ray meets no thing stays as it is: its place is on the table's
/// plane. Bounding boxes are the same in both worlds, so a ray means the same in them.
InputEvent with_target(InputEvent event, const WorldSnapshot& world);

}  // namespace continua
