// What the avatar's body can be told, and what it tells back. Both bodies, the MuJoCo one
// (simulation/physics_body) and the kinematic one (behaviour/kinematic_body), stand behind `Body`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/sim_time.h"
#include "world/relations.h"
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
  slide,    ///< as move, but along the table; what is not held is grasped first and released in the end
  move,     ///< grasped object is carried to the goal and set down there; the fingers stay closed
  push,     ///< the hand comes down behind the object and moves it along the table by contact; nothing is grasped
  turn,     ///< object turns about the vertical by `turn_rad`; what is not held is grasped first and set down again
  ungrasp,  ///< what is held is lowered onto what is below it, the fingers open, the hand backs off
  retract,  ///< the hand goes back to where it was at the start; what is held is kept
  stop,     ///< what is under way ends where it is, what waits is given up; what is held stays held, even in mid-air
  signal,   ///< a named gesture (nod, thumbs up); nothing but the log shows one the body has no motion for
};

/// Where something shall go. Resolved when the act begins, for a landmark may have moved since it was said.
struct Goal {
  std::optional<Relation> relation;               ///< to the landmarks; without it, p_WG is the goal
  std::vector<std::string> landmarks;             ///< objects or participants, landmarks_of(relation) many
  Perspective perspective = Perspective::avatar;  ///< whose sides are meant
  Vec3 p_WG = Vec3::Zero();                       ///< the point of the table under the object's centre
};

struct AvatarCommand {
  int id = 0;  ///< running number, given back in reports
  Capability what = Capability::signal;
  std::string object;             ///< what is reached for, pointed at, grasped, moved; empty: the goal's place is
  Goal goal;                      ///< for put, slide, push and move; for reach, point, look without object: the place
  std::optional<Goal> next = {};  ///< for grasp: where the object will go then, so that the grip suits that too
  std::vector<std::string> parts = {};  ///< for grasp: the components by which it is best held, best first
  double height_m = 0;                  ///< for lift
  double turn_rad = 0;                  ///< for turn: counterclockwise as seen from above
  std::string name;                     ///< for signal
};

/// How an act went.
struct ActReport {
  /// unstable: what was let go of moved again within a second.
  enum class Status { started, done, missed, dropped, blocked, unreachable, unstable, stopped };
  int id = 0;
  SimTime t;
  Status status = Status::done;
  double position_error_m = 0;  ///< put, slide, push, move, turn: distance from the goal on the table plane
  std::string reason;           ///< a sentence, when it was not done, or not just so
  std::vector<std::string> moved_aside = {};  ///< other objects that were put elsewhere to make room, in order
  double yaw_error = 0;  ///< of the object from how it was meant to be turned, radians; 0 for round things
  std::vector<std::string> touches = {};  ///< what the object that was handled touches in the end: objects, `table`
  std::vector<std::string> retries = {};  ///< why earlier attempts had failed, in order
};

std::string text(Capability what);
std::string text(ActReport::Status status);

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
  SimTime until;  ///< the time reached
};

/// The first thing that the command is about and that is not there; nothing if all are.
std::optional<std::string> missing_thing(const AvatarCommand& command, const WorldSnapshot& world);

/// Where and how an object comes to be.
struct Placement {
  Vec3 p_WO = Vec3::Zero();  ///< its centre, on the grid
  bool upright = false;      ///< it is stood on its end, its longest side vertical
};

/// Whose business it is that something already stands where an object shall go.
enum class Occupied {
  avoided,  ///< the nearest place to the ideal one at which the object overlaps nothing, on the table
  cleared,  ///< the body finds room itself, and is told the ideal place of a point, of a side and of what is on
            ///< something
};

/// A relation as it is said: "in front".
std::string in_words(Relation relation);

/// The object is brought to a goal.
bool moves_to_goal(Capability what);

/// Where the object comes to lie when `command`, a put, slide, push or move, succeeds in `world`. At a point it stands
/// on the table, whatever is there. Beside another thing (left, right, in_front, behind, touching) it ideally touches
/// it, at or beside it, near or between it keeps a distance; `in` it stands on the hollow's floor, lying if it fits so,
/// else upright; before a participant it is near the edge of the table. A side of the object itself is a step that way.
/// Whatever place is chosen, world/relations says of it that the relation holds. The error's sentence is the reason why
/// there is no such place. REQUIRES that nothing is missing.
Result<Placement> placement(const AvatarCommand& command, const WorldSnapshot& world, Occupied occupied);

/// A world with an avatar in it. One command runs at a time; further ones queue in order.
class Body {
 public:
  virtual ~Body() = default;
  virtual void command(const AvatarCommand& command) = 0;
  /// Lets the world go on until `t`, or until an act ends if that is earlier (WorldReport::until), so that what follows
  /// from it can begin at once; tells what happened. What is done as soon as it begins may end without ending this.
  /// `t` never decreases.
  virtual WorldReport advance(SimTime t) = 0;
  virtual WorldSnapshot snapshot() const = 0;
  /// Nothing moves and no command waits.
  virtual bool at_rest() const = 0;
};

}  // namespace continua
