// The state of an acting avatar, in structs by lifetime: the act, its attempts, the handling under way, its phase, and
// the motion.
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
  approach,  ///< the hand goes to the grasp
  close,     ///< the fingers close until they hold
  raise,     ///< the held object rises
  carry,     ///< the held object goes over its goal, or along the table to the goal
  lower,     ///< the held object goes down until it touches something
  insert,    ///< the held object goes down into a hollow until it touches something
  shove,     ///< the held object goes along the table into its goal and pushes others aside
  open,      ///< the fingers let go
  retreat,   ///< the hand backs off from the released object
  behind,    ///< the hand comes down behind the object to push
  push,      ///< the hand pushes
  back_off,  ///< the hand backs off after a push
  withdraw,  ///< the hand rises over everything between it and its home
  go_home,   ///< the hinges alone bring the arm home
  settle,    ///< waits until no object moves
  halt       ///< waits until arm and fingers stand
};

/// The command under way, and its result so far.
struct AvatarAct {
  AvatarCommand command = {};
  bool lets_go = false;  ///< the hand is empty in the end
  ActReport outcome = {};
  Vec3 p_WG = Vec3::Zero();           ///< the goal of the object's centre
  std::optional<double> yaw_WG = {};  ///< the object's yaw there
  std::vector<std::string> moved_aside = {};

  /// The first landmark of the goal, or empty.
  std::string landmark() const {
    return command.goal.landmarks.empty() ? std::string() : command.goal.landmarks.front();
  }
};

/// Earlier attempts of the act.
struct Attempts {
  int retried = 0;       ///< after a failure in the world
  int detours = 0;       ///< after the arm found no way
  int preparations = 0;  ///< handlings of other objects, to make room
  int pushes = 0;
  double short_m = 0;                ///< sum of the lengths that the last pushes, all in one direction, lacked
  std::vector<Grip> tried = {};      ///< grips that failed
  std::vector<Reason> retries = {};  ///< why the attempts failed
};

/// The object released last, and its pose then.
struct LetGo {
  int object = -1;
  Pose X_WO = {};
  double ago_s = 0;
};

struct HandlingUnderWay {
  bool preparing = false;  ///< the handling prepares the act; else it is the act itself
  Handling handling = {};
  Push push = {};
  int object = -1;  ///< index of the handled object
  std::optional<LetGo> let_go = {};
};

/// The phases still to come, the one under way first.
struct PhaseRun {
  std::deque<Phase> phases = {};
  bool failing = false;  ///< the phases end a failed handling
  double elapsed_s = 0;
  int steady_steps = 0;  ///< consecutive steps in which the phase's condition held
  double lag_rad = 0;    ///< of the hinges behind their targets, as of the last step in which the hand touched nothing
};

struct AvatarState {
  AvatarAct act = {};
  Attempts attempts = {};
  HandlingUnderWay under_way = {};
  PhaseRun run = {};
  Motion motion;
  int quiet_steps = 0;  ///< consecutive steps in which no object has moved
};

/// Objects without motion for this long, seconds, are taken to stay.
inline constexpr double quiet_s = 0.1;

}  // namespace continua
