// Everything that changes while the avatar acts, by how long it lasts: the act, its attempts, the handling under way,
// its phase, and the motion.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "continua/body/act_report.h"
#include "continua/body/avatar_command.h"
#include "continua/simulation/handling.h"
#include "continua/simulation/motion.h"
#include "continua/simulation/pushing.h"

namespace continua {

enum class Phase {
  hover,     ///< the hand goes over something to show it
  approach,  ///< … to where it grasps
  close,     ///< the fingers close until they hold
  raise,     ///< the held object rises
  carry,     ///< … goes over its goal, or along the table to it
  lower,     ///< … down until it touches something
  insert,    ///< … down into a hollow until it touches something
  shove,     ///< … along the table into its goal, and pushes others aside
  open,      ///< the fingers let go
  retreat,   ///< the hand backs off from what it let go of
  behind,    ///< the hand comes down behind what it shall push
  push,      ///< … and pushes it
  back_off,  ///< … and backs off
  withdraw,  ///< the hand rises over everything between it and its home
  go_home,   ///< the hinges alone bring the arm home
  settle,    ///< waits until no object moves
  halt       ///< waits until arm and fingers stand
};

/// The command that is being carried out, and its result so far.
struct AvatarAct {
  AvatarCommand command = {};
  bool lets_go = false;  ///< in the end the hand is empty
  ActReport outcome = {};
  Vec3 p_WG = Vec3::Zero();           ///< the goal of the object's centre
  std::optional<double> yaw_WG = {};  ///< the object's yaw there
  std::vector<std::string> moved_aside = {};

  /// The first landmark of the goal, or empty.
  std::string landmark() const {
    return command.goal.landmarks.empty() ? std::string() : command.goal.landmarks.front();
  }
};

/// What the act has tried so far.
struct Attempts {
  int retried = 0;       ///< after a failure in the world
  int detours = 0;       ///< after the arm found no way
  int preparations = 0;  ///< other handlings that made room
  int pushes = 0;
  double short_m = 0;                ///< by how much the last pushes, all in one direction, fell short together
  std::vector<Grip> tried = {};      ///< grips that failed
  std::vector<Reason> retries = {};  ///< why the attempts failed
};

/// The object that was released last, and its pose then.
struct LetGo {
  int object = -1;
  Pose X_WO = {};
  double ago_s = 0;
};

struct HandlingUnderWay {
  bool preparing = false;  ///< makes the act possible; otherwise this is the act itself
  Handling handling = {};
  Push push = {};
  int object = -1;  ///< index of the handled object
  std::optional<LetGo> let_go = {};
};

/// The phases still to come, the one under way first.
struct PhaseRun {
  std::deque<Phase> phases = {};
  bool failing = false;  ///< they end a handling that has failed
  double elapsed_s = 0;
  int steady_steps = 0;  ///< consecutive steps in which the phase's condition held
};

struct AvatarState {
  AvatarAct act = {};
  Attempts attempts = {};
  HandlingUnderWay under_way = {};
  PhaseRun run = {};
  Motion motion;
  int quiet_steps = 0;  ///< consecutive steps in which no object has moved
};

/// Objects that have not moved for this long, seconds, stay where they are.
inline constexpr double quiet_s = 0.1;

}  // namespace continua
