// The phases of the avatar's acts. Each begins from the state of the world at that time and ends by a measurement. The
// table in avatar_phases.cpp has a row for each phase, with a function that begins it and one that tells when it ends.
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

/// Sets arm and fingers their targets for the phase. False if the arm cannot do it.
bool begin_phase(Phase phase, PhaseWork& work);

/// Whether the phase has ended, as of this step.
PhaseEnd end_of_phase(Phase phase, PhaseWork& work);

/// The hand's pose for a reach or point. REQUIRES that the command is one of them.
Pose gesture_pose(const AvatarCommand& command, const Physics& physics, const WorldSnapshot& world);

/// Makes the fingers press on what is between them.
void hold_firmly(PhaseWork& work);

}  // namespace continua
