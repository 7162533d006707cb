// The phases of the avatar's acts. A phase begins from the present state of the world and ends by a measurement. The
// table in avatar_phases.cpp has a row for each phase with two functions: its beginning and its end.
#pragma once

#include <optional>

#include "continua/simulation/avatar_state.h"
#include "continua/simulation/physics.h"

namespace continua {

struct PhaseEnd {
  bool ended = false;
  std::optional<Reason> failure = {};  ///< the handling has failed in this phase
};

/// The avatar in its world.
struct PhaseWork {
  Physics& physics;
  AvatarState& state;
};

/// Sets the targets of arm and fingers for the phase. False if the arm finds no way.
bool begin_phase(Phase phase, PhaseWork& work);

/// The phase's end, judged at this step.
PhaseEnd end_of_phase(Phase phase, PhaseWork& work);

/// The hand's pose for a reach or point. REQUIRES that the command is one of them.
Pose gesture_pose(const AvatarCommand& command, const Physics& physics, const WorldSnapshot& world);

/// Makes the fingers press on the object between them.
void hold_firmly(PhaseWork& work);

}  // namespace continua
