// The avatar's acts. avatar_decisions.cpp decides from the state of the world what an act needs, as one handling of an
// object or several: something may have to be put away or moved aside first, and after a failure another way is tried.
// A handling is a succession of phases (avatar_phases.h).
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

  /// Begins an act. REQUIRES !busy(), that the act in progress may be superseded, or that this one is a stop.
  void begin(const AvatarCommand& command);

  bool busy() const { return busy_; }
  /// The act in progress only points or reaches: a newer command takes its place.
  bool may_be_superseded() const;

  /// To be called before each step of the physics. Returns the targets of the servos in that step.
  const AvatarTarget& update();

  /// For a world that was set back to an earlier state: ends the act in progress, if any, with that reason; the hand
  /// stays where it is in that state.
  void abandon(Reason reason);

  /// The report of an act that has ended, once; without id and time.
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
  Task task(const WorldSnapshot& world) const;
  std::optional<Grasp> grasp() const;
  bool has_goal() const;
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

/// Farther from its goal an object has missed it.
inline constexpr double set_down_error_m = 0.02;

}  // namespace continua
