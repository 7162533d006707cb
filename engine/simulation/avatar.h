// The avatar's acts. What an act needs is decided from how the world is (avatar_decisions.cpp), as one handling of an
// object or several: something may have to be put away or moved aside first, and what failed is tried again in another
// way. Each is a succession of phases (avatar_phases.cpp), begun from how the world is then and ended by what can be
// measured.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "behaviour/avatar_command.h"
#include "simulation/handling.h"
#include "simulation/physics.h"
#include "simulation/pushing.h"

namespace continua {

class Avatar {
 public:
  /// `physics` must outlive the avatar.
  explicit Avatar(Physics& physics);

  /// Begins an act. REQUIRES !busy(), that the act in progress may be superseded, or that this one is a stop.
  void begin(const AvatarCommand& command);

  bool busy() const { return busy_; }
  /// The act in progress only points or reaches: a newer command takes its place.
  bool may_be_superseded() const;

  /// Before each step of the physics: what the servos shall do in it.
  const AvatarTarget& update();

  /// The world has been set back to an earlier state: the act in progress, if any, ends with that reason, and the hand
  /// stays where it is then.
  void abandon(std::string reason);

  /// How the act went, once, when it has ended; without id and time.
  std::optional<ActReport> take_result();

 private:
  enum class Phase {
    hover,
    approach,
    close,
    raise,
    carry,
    lower,
    insert,
    shove,
    open,
    retreat,
    behind,
    push,
    back_off,
    withdraw,
    go_home,
    settle,
    halt
  };
  enum class Stage { preparation, act };  // what the phases are for: making the act possible, or the act itself

  // avatar_decisions.cpp
  void decide();
  void decide_handling(const WorldSnapshot& world);
  void decide_turn(const WorldSnapshot& world);
  void decide_push(const WorldSnapshot& world);
  void cannot(ActReport::Status status, std::string reason);
  void begin_attempt();
  void put_away(const WorldSnapshot& world);
  Task task(const WorldSnapshot& world) const;
  std::optional<Grasp> grasp() const;
  bool has_goal() const;
  std::string landmark() const;  // what the goal was said beside, or empty
  void begin_handling(const Handling& handling, bool in_hand);

  // avatar.cpp
  void halt();
  void phases_done();
  bool try_again();
  void judge();
  bool moved_again() const;
  bool is_related(const WorldSnapshot& world) const;
  void fail(ActReport::Status status, std::string reason);
  void end_act();
  int index_of(const std::string& object) const;

  // avatar_phases.cpp
  void begin_phase();
  bool move_to(Phase phase, const WorldSnapshot& world);
  bool phase_ended();
  bool go(const std::vector<Pose>& X_WT, const Pace& pace = {});
  void stop_here();
  void brake();
  Pace carrying_pace() const;
  void hold_firmly();
  bool arrived() const;
  bool pushes_hard();
  Pose hand_for_object(const Vec3& p_WO, bool turned) const;
  Pose gesture_pose(const WorldSnapshot& world) const;

  Physics& physics_;
  const double dt_s_;
  const ObjectShapes shapes_;
  const Means means_;

  // The act.
  AvatarCommand command_;
  bool busy_ = false;
  bool lets_go_ = false;  // in the end the hand is empty
  std::optional<ActReport> result_;
  ActReport outcome_;
  Vec3 p_WG_ = Vec3::Zero();      // the goal of the object's centre
  std::optional<double> yaw_WG_;  // how it shall be turned then
  int retried_ = 0, detours_ = 0, preparations_ = 0, pushes_ = 0;
  std::vector<Grip> tried_;  // grips that failed
  std::vector<std::string> moved_aside_, retries_;

  // What was let go of last, and where it was then.
  struct LetGo {
    int object = -1;
    Pose X_WO;
    double ago_s = 0;
  };
  std::optional<LetGo> let_go_;
  int quiet_steps_ = 0;  // for how long no object has moved

  // The handling under way.
  Stage stage_ = Stage::act;
  Handling handling_;
  Push push_;
  double short_m_ = 0;        // by how much the pushes before it in its direction fell short
  int object_ = -1;           // its index
  bool along_table_ = false;  // slides rather than is carried

  // The phase.
  std::deque<Phase> phases_;
  bool failing_ = false;  // they end a handling that has failed
  double phase_s_ = 0;
  int steps_so_ = 0;  // consecutive steps in which what the phase waits for was so

  // The motion.
  HandPath path_;
  double path_s_ = 0;
  ArmVector leftover_qdot_;  // speed of the motion before, which fades out
  ArmVector behind_q_;       // how far before its end a braking arm began
  double wanted_opening_m_ = 0, release_opening_m_ = 0;
  AvatarTarget target_;
};

/// Nothing has moved for so long, seconds: it will not by itself.
inline constexpr double quiet_s = 0.1;

/// Farther from its goal an object has missed it.
inline constexpr double set_down_error_m = 0.02;

/// The body only shows something, and moves nothing.
bool is_gesture(Capability what);

}  // namespace continua
