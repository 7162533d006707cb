// The avatar's acts. avatar_decisions.cpp divides an act into handlings of objects, by the state of the world: another
// object may have to be put away or moved aside first, and a failed handling is tried in another way. A handling is a
// succession of phases (avatar_phases.h).
#pragma once

#include <optional>
#include <string>

#include "continua/simulation/avatar_phases.h"
#include "continua/simulation/avatar_state.h"
#include "continua/simulation/physics.h"

namespace continua {

class Avatar {
 public:
  /// `physics` must outlive the avatar.
  explicit Avatar(Physics& physics);

  /// Begins an act. REQUIRES !busy(), or an act in progress that may be superseded, or a stop as the command.
  void begin(const AvatarCommand& command);

  bool busy() const { return busy_; }
  /// The act in progress only points or reaches, so a newer command may take its place.
  bool may_be_superseded() const;

  /// One step of the act, before each step of the physics. Returns the targets of the servos.
  const AvatarTarget& update();

  /// Ends the act in progress, if any, with that reason, after the world was set back to an earlier state. The hand
  /// stays where it is in that state.
  void abandon(Reason reason);

  /// The report of an ended act, once, without id and time.
  std::optional<ActReport> take_result();

 private:
  // avatar_decisions.cpp
  void decide();
  void decide_handling(const WorldSnapshot& world);
  void decide_turn(const WorldSnapshot& world);
  void decide_push(const WorldSnapshot& world);
  void cannot(Reason reason);
  void begin_attempt();
  void put_away(const WorldSnapshot& world);
  std::optional<Grasp> grasp() const;
  void begin_handling(const Handling& handling, bool in_hand);

  // avatar.cpp
  void halt();
  void begin_phases(std::deque<Phase> phases);
  void begin_phase();
  void phases_done();
  bool try_again();
  void measure(const WorldSnapshot& world);
  std::optional<Reason> judge(const WorldSnapshot& world) const;
  bool moved_again(const WorldSnapshot& world) const;
  bool is_related(const WorldSnapshot& world) const;
  void fail(Reason reason);
  void end_act();
  int index_of(const std::string& object) const;

  Physics& physics_;
  const ObjectShapes shapes_;
  const Means means_;
  bool busy_ = false;
  std::optional<ActReport> result_;
  AvatarState state_;
};

/// An object farther from its goal has missed it.
inline constexpr double set_down_error_m = 0.02;

}  // namespace continua
