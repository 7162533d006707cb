// What the avatar's body can be told, and what it tells back. Both bodies, the MuJoCo one
// (simulation/physics_body) and the kinematic one (behaviour/kinematic_body), stand behind `Body`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/sim_time.h"
#include "world/world_snapshot.h"

namespace continua {

/// What the body itself can do; everything else is composed of these.
enum class Capability {
  reach,    ///< hand goes over an object or place, without touching
  point,    ///< hand stretches toward an object or place
  look,     ///< gaze turns to an object or place; nothing but the log shows it on a body without a head
  grasp,    ///< fingers close on the object, which stays where it is
  lift,     ///< grasped object rises by `height_m` and stays held
  put,      ///< object is grasped if it is not, carried to the goal, set down and released
  slide,    ///< as put, but along the table
  ungrasp,  ///< fingers open
  signal,   ///< a named gesture (nod, thumbs up); nothing but the log shows one the body has no motion for
};

/// Where something shall go. Resolved when the act begins, for a landmark may have moved since it was said.
/// Sides are the avatar's, who looks along -y: its left is +x, its front (toward itself, as one says
/// "in front of the cup" of what stands between the cup and oneself) is +y.
struct Goal {
  enum class Relation { at, on, left_of, right_of, in_front_of, behind };
  Relation relation = Relation::at;
  std::string landmark;      ///< for every relation but `at`
  Vec3 p_WG = Vec3::Zero();  ///< for `at`: the point of the table under the object's centre
};

struct AvatarCommand {
  int id = 0;  ///< running number, given back in reports
  Capability what = Capability::signal;
  std::string object;   ///< what is reached for, pointed at, grasped, moved; empty: the goal's place is
  Goal goal;            ///< for put and slide; for reach, point, look without object: the place
  double height_m = 0;  ///< for lift
  std::string name;     ///< for signal
};

/// How an act went.
struct ActReport {
  enum class Status { started, done, missed, dropped, blocked, unreachable };
  int id = 0;
  SimTime t;
  Status status = Status::done;
  double position_error_m = 0;  ///< put, slide: distance of the object from its goal on the table plane once released
  std::string reason;           ///< a sentence, when it was not done
  std::vector<std::string> moved_aside = {};  ///< other objects that were put elsewhere to make room, in order
};

std::string text(Capability what);
std::string text(ActReport::Status status);
std::string text(Goal::Relation relation);

/// Poses of the bodies that moved by more than the grid since they were last told. At most one per 1/30 s.
struct PoseSample {
  SimTime t;
  std::map<std::string, Pose> bodies;
};

/// A span of time in which nothing moved and physics was not stepped (semantics §6).
struct RestSpan {
  SimTime from, to;
};

/// What happened in the world while time went on, each in order of time.
struct WorldReport {
  std::vector<ActReport> acts;
  std::vector<PoseSample> poses;
  std::vector<RestSpan> rests;
};

/// Where the object's centre comes to lie when `command` succeeds in `world`, on the grid. `command.what` is put or
/// slide. `at` and sides keep the bottom on what is under it: the table, or for `on` the landmark's top. Sides touch
/// the landmark. REQUIRES that object and landmark are in `world`.
Vec3 goal_position(const AvatarCommand& command, const WorldSnapshot& world);

/// A world with an avatar in it. One command runs at a time; further ones queue in order.
class Body {
 public:
  virtual ~Body() = default;
  virtual void command(const AvatarCommand& command) = 0;
  /// Lets the world go on until `t` and tells what happened. `t` never decreases.
  virtual WorldReport advance(SimTime t) = 0;
  virtual WorldSnapshot snapshot() const = 0;
  /// Nothing moves and no command waits.
  virtual bool at_rest() const = 0;
};

}  // namespace continua
