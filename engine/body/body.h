// The interface of the avatar's body. Two bodies implement it: the MuJoCo one (simulation/physics_body) and the
// kinematic one (body/kinematic_body).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/body/act_report.h"
#include "continua/body/avatar_command.h"

namespace continua {

/// Poses of the bodies that moved by more than the grid since their last sample. At most one sample per 1/30 s.
struct PoseSample {
  SimTime t;
  std::map<std::string, Pose> bodies;
};

/// A span of time in which nothing moved and physics was not stepped.
struct RestSpan {
  SimTime from, to;
};

/// The events of the world in a span of time, each list in order of time.
struct WorldReport {
  std::vector<ActReport> acts;
  std::vector<PoseSample> poses;
  std::vector<RestSpan> rests;
  SimTime until;  ///< the time reached
};

/// A world with an avatar in it. One command runs at a time; further ones queue in order.
class Body {
 public:
  virtual ~Body() = default;
  virtual void command(const AvatarCommand& command) = 0;
  /// Lets the world go on until `t` or until an act ends, whichever is earlier (WorldReport::until): the consequences
  /// of an act begin at once. An act that takes no time may end without ending the span. `t` never decreases.
  virtual WorldReport advance(SimTime t) = 0;
  /// While held, an act that has begun changes nothing. A body whose acts take their time may ignore this.
  virtual void hold(bool /*held*/) {}
  virtual WorldSnapshot snapshot() const = 0;
  /// Nothing moves and no command waits.
  virtual bool at_rest() const = 0;
};

}  // namespace continua
