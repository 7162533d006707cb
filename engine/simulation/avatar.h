// The avatar's acts: each command as a succession of phases (approach, close, carry, lower, open, …), each begun from
// how the world is then, and judged at its end by what can be measured.
#pragma once

#include <deque>
#include <optional>

#include "behaviour/avatar_command.h"
#include "simulation/grip_choice.h"
#include "simulation/physics.h"
#include "simulation/set_down.h"

namespace continua {

class Avatar {
 public:
  /// `physics` must outlive the avatar.
  explicit Avatar(Physics& physics);

  /// Begins an act. REQUIRES !busy(), or that the act in progress may be superseded.
  void begin(const AvatarCommand& command);

  bool busy() const { return busy_; }
  /// The act in progress only points or reaches: a newer command takes its place.
  bool may_be_superseded() const;

  /// Before each step of the physics: what the servos shall do in it.
  const AvatarTarget& update();

  /// How the act went, once, when it has ended; without id and time.
  std::optional<ActReport> take_result();

 private:
  enum class Phase { hover, approach, close, raise, carry, lower, shove, open, retreat, go_home, settle };

  bool decide();
  bool decide_move(const ObjectState& object, const WorldSnapshot& world);
  void begin_phase();
  bool phase_ended();
  void end_act();
  void fail(ActReport::Status status, std::string reason);

  bool go(const std::vector<Pose>& X_WT, const Pace& pace = {});
  void stop_here();
  bool arrived() const;
  bool pushes_hard();
  std::vector<Pose> over(const Pose& X_WT, const WorldSnapshot& world) const;
  Pose hand_for_object(const Vec3& p_WO, double yaw) const;
  Pose hover_pose(const WorldSnapshot& world) const;
  Pose pointing_pose(const Vec3& p_W) const;
  double height_under(const ObjectState& object, const WorldSnapshot& world) const;
  bool way_is_free(const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world) const;

  Physics& physics_;
  const double dt_s_;

  // The act.
  AvatarCommand command_;
  bool busy_ = false;
  std::optional<ActReport> result_;
  ActReport outcome_;
  int object_ = -1;  // index of the object that is moved
  Grip grip_;
  Vec3 p_WG_ = Vec3::Zero();  // its centre's goal
  SetDown set_down_;          // how it gets there
  bool along_table_ = false;  // slides rather than is carried

  // The phase.
  std::deque<Phase> phases_;
  double phase_s_ = 0;
  int steps_so_ = 0;  // consecutive steps in which what the phase waits for was so

  // The motion.
  HandPath path_;
  double path_s_ = 0;
  ArmVector leftover_qdot_ = ArmVector::Zero();  // speed of the motion before, which fades out
  double wanted_opening_m_ = 0, release_opening_m_ = 0;
  AvatarTarget target_;
};

}  // namespace continua
